//! The module of a text from functions that are parsed already: parsing is most of the time that a link takes.

use std::collections::BTreeMap;
use std::ops::Range;

use naga::{
    Arena, ArraySize, Block, Expression, Function, FunctionArgument, FunctionResult, Handle, LocalVariable, Module,
    Span, Statement, StructMember, Type, TypeInner,
};

/// A text and what naga has parsed from it.
pub(crate) type Source<'a> = (&'a str, &'a Module);

/// What naga parses from a text, but for the order of functions and types: functions that sources have are not parsed
/// again but taken from there.
///
/// Nothing where naga refuses the text, or where a function is unlike those of the shelf; such a text is to be parsed
/// whole. The caller sees to it that what these functions mention means the same in the text.
pub(crate) fn joined(text: &str, sources: &[Source<'_>]) -> Option<Module> {
    let declarations = prefilter_wgsl::declarations(text);
    let known = known(sources);
    let (mut held, mut bodies) = (BTreeMap::new(), Vec::new());
    for declaration in &declarations {
        let Range { start, end } = declaration.body;
        let same = |held: &&Held<'_>| end > start + 1 && text[..end].ends_with(held.text);
        if let Some(&found) = known.get(declaration.name).filter(same) {
            held.insert(declaration.name, (found, end));
            bodies.push(declaration.body.clone());
        }
    }
    let mut module = naga::front::wgsl::parse_str(&emptied(text, &bodies)).ok()?;
    let types = sources.iter().map(|(_, source)| moved_types(source, &mut module)).collect::<Option<_>>()?;
    let mut own = std::mem::take(&mut module.functions);
    let mut join = Join { held, types, module, taken: BTreeMap::new() };
    let mut places = Vec::with_capacity(own.len());
    for (_, mut function, span) in own.drain() {
        places.push(match join.held.get_key_value(function.name.as_deref()?) {
            Some((&name, _)) => join.take(name)?,
            None => {
                rewrite(&mut function, |span| span, |callee| places.get(callee.index()).copied())?;
                join.module.functions.append(function, span)
            }
        });
    }
    for point in &mut join.module.entry_points {
        rewrite(&mut point.function, |span| span, |callee| places.get(callee.index()).copied())?;
    }
    Some(join.module)
}

/// A function of a source.
#[derive(Clone, Copy)]
struct Held<'a> {
    /// The source's number and module.
    source: (usize, &'a Module),
    function: Handle<Function>,
    /// From `fn` to the closing brace.
    text: &'a str,
    /// Where it ends in the source's text.
    end: usize,
}

/// The functions of all sources by their names.
fn known<'a>(sources: &[Source<'a>]) -> BTreeMap<&'a str, Held<'a>> {
    let mut known = BTreeMap::new();
    for (number, &(text, module)) in sources.iter().enumerate() {
        for (handle, function) in module.functions.iter() {
            let place = module.functions.get_span(handle).to_range();
            if let (Some(name), Some(place)) = (function.name.as_deref(), place) {
                let end = place.end;
                known.insert(name, Held { source: (number, module), function: handle, text: &text[place], end });
            }
        }
    }
    known
}

/// The text with nothing but spaces between the braces of bodies, so that all else keeps its place.
fn emptied(text: &str, bodies: &[Range<usize>]) -> String {
    let mut emptied = String::with_capacity(text.len());
    for body in bodies {
        emptied.push_str(&text[emptied.len()..=body.start]);
        emptied.extend(std::iter::repeat_n(' ', body.len() - 2));
    }
    emptied.push_str(&text[emptied.len()..]);
    emptied
}

/// The handles that a source's types have in a module, to which they are added.
fn moved_types(source: &Module, module: &mut Module) -> Option<Vec<Handle<Type>>> {
    let mut moved: Vec<Handle<Type>> = Vec::with_capacity(source.types.len());
    for (_, kind) in source.types.iter() {
        let inner = match kind.inner {
            TypeInner::Array { base, size: size @ ArraySize::Constant(_), stride } => {
                TypeInner::Array { base: moved[base.index()], size, stride }
            }
            TypeInner::Pointer { base, space } => TypeInner::Pointer { base: moved[base.index()], space },
            TypeInner::Struct { ref members, span } => {
                let member = |member: &StructMember| StructMember { ty: moved[member.ty.index()], ..member.clone() };
                TypeInner::Struct { members: members.iter().map(member).collect(), span }
            }
            TypeInner::Array { .. } | TypeInner::BindingArray { .. } => return None,
            ref inner => inner.clone(),
        };
        moved.push(module.types.insert(Type { name: kind.name.clone(), inner }, Span::UNDEFINED));
    }
    source.special_types.predeclared_types.is_empty().then_some(moved)
}

/// A module that grows by functions, each behind those that it calls.
struct Join<'a> {
    /// The functions to take, by name, and where each ends in the joined text.
    held: BTreeMap<&'a str, (Held<'a>, usize)>,
    /// For each source where its types are now.
    types: Vec<Vec<Handle<Type>>>,
    module: Module,
    taken: BTreeMap<&'a str, Handle<Function>>,
}

impl<'a> Join<'a> {
    /// Where a function is now that some source holds.
    fn take(&mut self, name: &str) -> Option<Handle<Function>> {
        if let Some(&taken) = self.taken.get(name) {
            return Some(taken);
        }
        let (held, end) = *self.held.get(name)?;
        let (number, source) = held.source;
        let function = &source.functions[held.function];
        let place = |span: Span| match span.to_range() {
            Some(Range { start, end: last }) if start + end >= held.end => {
                Span::from(start + end - held.end..last + end - held.end)
            }
            _ => Span::UNDEFINED,
        };
        let mut moved = self.moved(number, source, function, place)?;
        rewrite(&mut moved, place, |callee| self.take(source.functions[callee].name.as_deref()?))?;
        let taken = self.module.functions.append(moved, place(source.functions.get_span(held.function)));
        self.taken.insert(function.name.as_deref()?, taken);
        Some(taken)
    }

    /// A function of a source with the module's types and constants, calls aside.
    fn moved(
        &self,
        source: usize,
        from: &Module,
        function: &Function,
        place: impl Fn(Span) -> Span,
    ) -> Option<Function> {
        let kind = |kind: Handle<Type>| self.types[source][kind.index()];
        let mut expressions = Arena::new();
        for (handle, expression) in function.expressions.iter() {
            let moved = match *expression {
                Expression::ZeroValue(ty) => Expression::ZeroValue(kind(ty)),
                Expression::Compose { ty, ref components } => {
                    Expression::Compose { ty: kind(ty), components: components.clone() }
                }
                Expression::Constant(constant) => {
                    let name = &from.constants[constant].name;
                    let mut named = self.module.constants.iter().filter(|(_, known)| known.name == *name);
                    Expression::Constant(named.next()?.0)
                }
                Expression::Override(_)
                | Expression::GlobalVariable(_)
                | Expression::AtomicResult { .. }
                | Expression::WorkGroupUniformLoadResult { .. }
                | Expression::SubgroupOperationResult { .. } => return None,
                ref other => other.clone(),
            };
            expressions.append(moved, place(function.expressions.get_span(handle)));
        }
        let mut local_variables = Arena::new();
        for (handle, local) in function.local_variables.iter() {
            let moved = LocalVariable { ty: kind(local.ty), ..local.clone() };
            local_variables.append(moved, place(function.local_variables.get_span(handle)));
        }
        let argument = |one: &FunctionArgument| FunctionArgument { ty: kind(one.ty), ..one.clone() };
        Some(Function {
            name: function.name.clone(),
            arguments: function.arguments.iter().map(argument).collect(),
            result: function.result.as_ref().map(|one| FunctionResult { ty: kind(one.ty), ..one.clone() }),
            local_variables,
            expressions,
            named_expressions: function.named_expressions.clone(),
            body: function.body.clone(),
            diagnostic_filter_leaf: self.module.diagnostic_filter_leaf,
        })
    }
}

/// Gives each call its callee's place in the module, and each statement its own in the text.
fn rewrite(
    function: &mut Function,
    place: impl Fn(Span) -> Span,
    mut callee: impl FnMut(Handle<Function>) -> Option<Handle<Function>>,
) -> Option<()> {
    for (_, expression) in function.expressions.iter_mut() {
        if let Expression::CallResult(called) = expression {
            *called = callee(*called)?;
        }
    }
    statements(&mut function.body, &mut |statement, span| {
        *span = place(*span);
        match statement {
            Statement::Call { function, .. } => callee(*function).map(|place| *function = place),
            _ => Some(()),
        }
    })
}

/// Every statement of a block and of those within it.
fn statements(block: &mut Block, each: &mut impl FnMut(&mut Statement, &mut Span) -> Option<()>) -> Option<()> {
    for (statement, span) in block.span_iter_mut() {
        each(statement, span?)?;
        match statement {
            Statement::Block(block) => statements(block, each)?,
            Statement::If { accept, reject, .. } => {
                statements(accept, each)?;
                statements(reject, each)?;
            }
            Statement::Switch { cases, .. } => {
                cases.iter_mut().try_for_each(|case| statements(&mut case.body, each))?
            }
            Statement::Loop { body, continuing, .. } => {
                statements(body, each)?;
                statements(continuing, each)?;
            }
            _ => {}
        }
    }
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use naga::front::wgsl::{parse_str, ParseError};

    /// The constants in functions: names, or values where they have none.
    fn constants(module: &Module) -> Vec<String> {
        let expressions = module.functions.iter().flat_map(|(_, one)| one.expressions.iter());
        let constants = expressions.filter_map(|(_, one)| match one {
            Expression::Constant(constant) => module.constants[*constant].name.clone(),
            Expression::Literal(literal) => Some(format!("{literal:?}")),
            _ => None,
        });
        constants.collect()
    }

    /// Whether they are what naga parses: spirv-tests/tests/joined.rs.
    #[test]
    fn every_function_of_the_shelf_can_be_taken() -> Result<(), ParseError> {
        let shelf: String = prefilter_wgsl::FILES.iter().map(|file| file.text).collect();
        let source = parse_str(&shelf)?;
        let module = joined(&format!("fn own() -> f32 {{ return normal_cdf(1.0); }}\n{shelf}"), &[(&shelf, &source)]);
        assert_eq!(module.map(|module| module.functions.len()), Some(source.functions.len() + 1));
        Ok(())
    }

    #[test]
    fn bodies_alike_are_taken_and_others_parsed() -> Result<(), ParseError> {
        let [one, two] = ["fn one() -> f32 { return 1.0; }", "fn one() -> f32 { return 2.0; }"];
        let source = parse_str("fn one() -> f32 { return 3.0; }")?; // tells what is taken from what is parsed
        assert_eq!(joined(one, &[(one, &source)]).as_ref().map(constants), Some(vec!["F32(3.0)".to_owned()]));
        assert_eq!(joined(two, &[(one, &source)]).as_ref().map(constants), Some(vec!["F32(2.0)".to_owned()]));
        Ok(())
    }

    #[test]
    fn constants_are_found_by_their_names() -> Result<(), ParseError> {
        let behind = "const two: f32 = 2.0;\nfn twice(x: f32) -> f32 { return x * two; }";
        let held = format!("const one: f32 = 1.0;\n{behind}");
        let text = format!("const zero: f32 = 0.0;\n{held}\nconst three: f32 = 3.0;");
        let module = joined(&text, &[(&held, &parse_str(&held)?)]);
        assert_eq!(module.as_ref().map(constants), Some(vec!["two".to_owned()]));
        Ok(())
    }

    #[test]
    fn bodies_make_room_for_spaces() {
        let text = "fn a() { return; }\nfn b(){}\n// behind";
        assert_eq!(emptied(text, &[7..18, 25..27]), "fn a() {         }\nfn b(){}\n// behind");
    }
}
