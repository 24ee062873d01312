//! Structures that a function of the shelf makes: `tails from height_skewed` in a domain.
//!
//! Such a parameter stands for the maker's, with the maker's ranges: the kernel calls the maker, and the reference
//! takes the maker's numbers. Members that only make sense together need no ranges of their own.

use crate::contract::parts;
use crate::kernel::Function;
use crate::signature::Shape;

impl Function {
    /// The function with the makers' parameters in place of the structures that they make.
    ///
    /// # Errors
    /// A message where a maker is not of the shelf, has no domain, or the parameter is no structure.
    pub(crate) fn with_makers(mut self) -> Result<Self, String> {
        for (name, maker) in makers(&self.documentation) {
            let fail = |what: &str| format!("`{}`: `Domain:` says `{name} from {maker}`; {what}", self.name);
            let all = Self::declared();
            let (path, made) = all
                .iter()
                .find(|(_, made)| made.name == maker)
                .ok_or_else(|| fail("the shelf has no such function"))?;
            let made = Self::new(path, made, String::new())?;
            let domain = clause(&made.documentation).ok_or_else(|| fail("it has no domain"))?;
            let parameter = self.signature.parameters.iter_mut().find(|parameter| parameter.0 == name);
            let shape = parameter.map(|parameter| &mut parameter.1);
            match shape {
                Some(shape) if *shape == made.signature.result && matches!(shape, Shape::Structure(..)) => {
                    *shape = Shape::Structure(made.name.clone(), made.signature.parameters.clone());
                }
                _ => return Err(fail("the parameter is not the structure that it makes")),
            }
            let ranges = parts(domain.trim_end_matches('.')).into_iter().map(|range| format!("{name}.{range}"));
            let ranges = ranges.collect::<Vec<_>>().join(", ");
            self.documentation = self.documentation.replace(&format!("{name} from {maker}"), &ranges);
            self.needs(&maker);
        }
        Ok(self)
    }
}

/// The `Domain:` of a documentation on one line, without its label.
fn clause(documentation: &str) -> Option<String> {
    let lines = documentation.lines().skip_while(|line| !line.starts_with("Domain:"));
    let own = lines.enumerate().take_while(|(at, line)| *at == 0 || !(line.is_empty() || line.starts_with("Error:")));
    let words: Vec<&str> = own.flat_map(|(_, line)| line.split_whitespace()).skip(1).collect();
    Some(words.join(" ")).filter(|text| !text.is_empty())
}

/// Parameters and what makes them.
fn makers(documentation: &str) -> Vec<(String, String)> {
    let domain = clause(documentation).unwrap_or_default();
    let parts = domain.split(", ").filter_map(|part| part.split_once(" from "));
    parts.map(|(name, maker)| (name.to_owned(), maker.trim_end_matches('.').to_owned())).collect()
}
