//! A filter over a map: what is compared, over which pixels, and what is true.

use super::brute::Brute;
use super::pixel::{Drawn, Pixel};
use crate::exports::ExportKernel;
use prefilter::gpu::Device;
use prefilter::{Error, Module};

/// What a row is, besides what it is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The map at the mean.
    Naive,
    /// The paper's recipe.
    Paper,
    /// All heights or slopes counted alike, whatever the view.
    Independent,
    /// A tier of the ladder.
    Tier,
}

/// One way to evaluate a filter.
#[derive(Clone, Debug)]
pub struct Row {
    /// What it is.
    pub role: Role,
    /// What it is called.
    pub label: String,
    /// What a scene without settings chooses.
    pub default: bool,
    /// What its function calls.
    pub(super) modules: Vec<Module>,
    /// A text before the modules, where the function is in none of them.
    pub(super) text: String,
    /// The function.
    pub(super) function: String,
    /// Pixels are shown to it from straight above.
    straight: bool,
    /// Whether its module's bound is one against the truth.
    bounded: bool,
}

impl Row {
    /// The first export of a module.
    pub fn of(role: Role, label: impl ToString, module: Module) -> Self {
        let function = module.exports().first().map_or(String::new(), |export| export.name.clone());
        let bounded = role != Role::Independent;
        let (label, modules) = (label.to_string(), vec![module]);
        Self { role, label, default: false, modules, text: String::new(), function, straight: false, bounded }
    }

    /// A function of a text before modules.
    pub fn text(role: Role, label: impl ToString, modules: Vec<Module>, text: &str, function: &str) -> Self {
        let (label, text, function) = (label.to_string(), text.to_owned(), function.to_owned());
        Self { role, label, default: false, modules, text, function, straight: false, bounded: false }
    }

    /// The same, told that it is seen from straight above.
    #[must_use]
    pub fn straight(self) -> Self {
        Self { straight: true, ..self }
    }

    /// The same, whose bound is against a model of its own and not shown.
    #[must_use]
    pub fn unbounded(self) -> Self {
        Self { bounded: false, ..self }
    }

    /// The rows with what a scene without settings chooses marked, or added where it is none of them.
    pub fn with_default(mut rows: Vec<Self>, default: Module) -> Vec<Self> {
        let same =
            |row: &&mut Self| row.role == Role::Tier && row.modules.iter().any(|own| own.wgsl() == default.wgsl());
        match rows.iter_mut().find(same) {
            Some(row) => row.default = true,
            None => rows.push(Self { default: true, ..Self::of(Role::Tier, "what is chosen", default) }),
        }
        rows
    }

    /// The function on a device.
    ///
    /// # Errors
    /// What the device refuses.
    pub fn kernel(&self, device: &Device) -> Result<ExportKernel, Error> {
        let modules: Vec<&Module> = self.modules.iter().collect();
        match modules[..] {
            [module] if self.text.is_empty() => {
                let export = module.exports().iter().find(|export| export.name == self.function);
                let export = export.ok_or_else(|| Error::Conflict(format!("no export `{}`", self.function)))?;
                ExportKernel::new(device, module, export)
            }
            _ => ExportKernel::before(device, &modules, &self.text, &self.function),
        }
    }

    /// The numbers that the function takes of pixels.
    pub fn points(&self, kernel: &ExportKernel, pixels: &[Pixel]) -> Vec<f32> {
        let parameters = kernel.parameters();
        let shown = |pixel: &Pixel| if self.straight { pixel.straight() } else { *pixel };
        pixels.iter().flat_map(|pixel| shown(pixel).numbers(&parameters, &[])).collect()
    }

    /// The largest error that the module admits.
    pub fn bound(&self) -> Option<f64> {
        self.modules.first().filter(|_| self.bounded).map(|module| module.bound().value().into())
    }

    /// Operations, fetches and table bytes.
    ///
    /// # Errors
    /// What naga refuses of a text.
    pub fn cost(&self) -> Result<[usize; 3], Error> {
        let modules: Vec<&Module> = self.modules.iter().collect();
        let cost = match modules[..] {
            [module] if self.text.is_empty() => module.cost(),
            _ => {
                let cost = prefilter::link(&modules, &self.text)?.cost(&self.function).unwrap_or_default();
                prefilter::Cost { table_bytes: modules.iter().map(|module| module.cost().table_bytes).sum(), ..cost }
            }
        };
        Ok([cost.operations, cost.fetches, cost.table_bytes])
    }
}

/// The color of a pixel by the integral.
pub type Truth = Box<dyn Fn(&Pixel) -> [f64; 4] + Sync>;

/// A filter over a map.
pub struct Case {
    /// Its name in files: the filter's and the map's.
    pub stem: String,
    /// The map, in a word or two.
    pub map: String,
    /// The ways to evaluate it; the first is naive.
    pub rows: Vec<Row>,
    /// What pixels are drawn from.
    pub drawn: Drawn,
    /// Which part of the pixels of a cheap truth is judged.
    pub share: usize,
    /// The integral.
    pub truth: Truth,
    /// The texts that the truth depends on, but for references and transfers, on which all do.
    pub sources: Vec<&'static str>,
    /// The same by stratified samples.
    pub brute: Brute,
}
