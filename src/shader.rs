//! Validated text, and the other languages that naga writes from it.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};

use crate::cost::{self, Cost};
use crate::join;
use crate::linkage;
use crate::module::Module;
use crate::Error;

/// WGSL that naga has parsed and validated without any capability flag.
#[derive(Clone, Debug)]
pub struct Shader {
    wgsl: String,
    parsed: Arc<(naga::Module, ModuleInfo)>,
}

impl Shader {
    /// Parses and validates a whole text; `path` names it in messages.
    pub(crate) fn new(path: &str, wgsl: String) -> Result<Self, Error> {
        let module = naga::front::wgsl::parse_str(&wgsl).map_err(|error| {
            let place = error.location(&wgsl);
            refused(path, place, &with_hint(&error.emit_to_string_with_path(&wgsl, path), &wgsl))
        })?;
        let info = validator().validate(&module).map_err(|error| {
            let place = error.location(&wgsl);
            refused(path, place, &error.emit_to_string_with_path(&wgsl, path))
        })?;
        Ok(Self { wgsl, parsed: Arc::new((module, info)) })
    }

    /// As [`Self::new`], without parsing again what modules have of it.
    fn joined(path: &str, wgsl: String, modules: &[&Module]) -> Result<Self, Error> {
        let sources: Vec<_> = modules.iter().map(|module| (module.wgsl(), module.linked.parsed().0)).collect();
        let joined =
            join::joined(&wgsl, &sources).and_then(|module| Some((validator().validate(&module).ok()?, module)));
        match joined {
            Some((info, module)) => Ok(Self { wgsl, parsed: Arc::new((module, info)) }),
            None => Self::new(path, wgsl),
        }
    }

    /// The text.
    pub fn wgsl(&self) -> &str {
        &self.wgsl
    }

    pub(crate) fn parsed(&self) -> (&naga::Module, &ModuleInfo) {
        (&self.parsed.0, &self.parsed.1)
    }

    /// What a call of one of its functions costs, each loop taken for a single iteration; nothing where there is no
    /// function of this name.
    ///
    /// ```
    /// let shader = prefilter::link(&[], "fn half(x: f32) -> f32 { return 0.5 * x; }")?;
    /// assert_eq!(shader.cost("half").map(|cost| cost.operations), Some(1));
    /// # Ok::<(), prefilter::Error>(())
    /// ```
    pub fn cost(&self, function: &str) -> Option<Cost> {
        let (module, info) = self.parsed();
        cost::call(module, info, function, &BTreeMap::new())
    }

    /// SPIR-V 1.3, for Vulkan 1.1 and later where the text has entry points. The same text gives the same words.
    ///
    /// In the positions that a vertex entry point returns, naga negates y: up in WebGPU, down in Vulkan.
    ///
    /// # Errors
    /// What naga's writer refuses.
    pub fn spirv(&self) -> Result<Vec<u32>, Error> {
        self.written(naga::back::spv::WriterFlags::empty())
    }

    /// SPIR-V of a text without entry points, with these functions for a linker.
    pub(crate) fn spirv_exporting(&self, names: &[&str]) -> Result<Vec<u32>, Error> {
        let named = self.written(naga::back::spv::WriterFlags::DEBUG)?;
        Ok(linkage::exported(named, names))
    }

    /// naga's default flags without those that depend on the build's profile, and others.
    fn written(&self, others: naga::back::spv::WriterFlags) -> Result<Vec<u32>, Error> {
        use naga::back::spv;
        let (module, info) = self.parsed();
        let mut options = spv::Options { lang_version: (1, 3), ..Default::default() };
        options.flags = options.flags.difference(spv::WriterFlags::DEBUG).union(others);
        spv::write_vec(module, info, &options, None).map_err(|error| backend("SPIR-V", &error))
    }

    /// GLSL of one entry point: `version` 300, 310 or 320 where `es`, else 330 to 460.
    ///
    /// In the positions that a vertex entry point returns, naga negates y and spreads the depth from [0, 1] to
    /// [−1, 1]: textures drawn to are then as in WebGPU, a picture drawn straight to the screen is upside down.
    ///
    /// # Errors
    /// An unknown version or entry point; what the language cannot express, such as compute before 310 es.
    #[cfg(feature = "glsl")]
    pub fn glsl(&self, entry: &str, version: u16, es: bool) -> Result<String, Error> {
        use naga::back::glsl;
        let (module, info) = self.parsed();
        let Some(point) = module.entry_points.iter().find(|point| point.name == entry) else {
            let names: Vec<String> = module.entry_points.iter().map(|point| format!("`{}`", point.name)).collect();
            let known = if names.is_empty() { "none".to_owned() } else { names.join(", ") };
            let message = format!("there is no entry point `{entry}`; the shader has {known}");
            return Err(Error::Backend { language: "GLSL", message });
        };
        let version =
            if es { glsl::Version::Embedded { version, is_webgl: false } } else { glsl::Version::Desktop(version) };
        let options = glsl::Options { version, ..Default::default() };
        let pipeline =
            glsl::PipelineOptions { shader_stage: point.stage, entry_point: entry.to_owned(), multiview: None };
        let mut text = String::new();
        glsl::Writer::new(&mut text, module, info, &options, &pipeline, naga::proc::BoundsCheckPolicies::default())
            .and_then(|mut writer| writer.write())
            .map_err(|error| backend("GLSL", &error))?;
        Ok(text)
    }

    /// HLSL of every entry point, shader model 5.1.
    ///
    /// # Errors
    /// What naga's writer refuses.
    #[cfg(feature = "hlsl")]
    pub fn hlsl(&self) -> Result<String, Error> {
        use naga::back::hlsl;
        let (module, info) = self.parsed();
        let options = hlsl::Options { fake_missing_bindings: true, ..Default::default() };
        let pipeline = hlsl::PipelineOptions::default();
        let mut text = String::new();
        hlsl::Writer::new(&mut text, &options, &pipeline)
            .write(module, info, None)
            .map_err(|error| backend("HLSL", &error))?;
        Ok(text)
    }

    /// Metal's language, version 2.0, of every entry point.
    ///
    /// # Errors
    /// What naga's writer refuses.
    #[cfg(feature = "msl")]
    pub fn msl(&self) -> Result<String, Error> {
        use naga::back::msl;
        let (module, info) = self.parsed();
        let options = msl::Options { lang_version: (2, 0), fake_missing_bindings: true, ..Default::default() };
        let written = msl::write_string(module, info, &options, &msl::PipelineOptions::default());
        written.map(|(text, _)| text).map_err(|error| backend("MSL", &error))
    }

    /// The validated module and its analysis; tied to naga's version, unlike the text.
    #[cfg(feature = "naga")]
    pub fn naga(&self) -> (&naga::Module, &ModuleInfo) {
        self.parsed()
    }
}

/// Your text with modules behind it, and behind them the shelf functions that any of them mentions, validated.
///
/// What modules have is not parsed again, which takes half the time of parsing the whole text; but it is where one of
/// them has a driver of yours, as your text may declare that anew.
///
/// # Errors
/// As [`Module::link`].
pub fn link(modules: &[&Module], text: &str) -> Result<Shader, Error> {
    let mut whole = text.to_owned();
    for module in modules {
        if !whole.is_empty() && !whole.ends_with('\n') {
            whole.push('\n');
        }
        if !whole.is_empty() {
            whole.push('\n');
        }
        whole.push_str(&module.glue);
    }
    for (number, module) in modules.iter().enumerate() {
        modules[..number].iter().try_for_each(|other| shares_nothing(module, other))?;
        add_foreign(&mut whole, &module.foreign);
    }
    let path = "shader.wgsl";
    let linked = prefilter_wgsl::link(&whole).map_err(|collision| Error::Collision { path: path.into(), collision })?;
    let mut own = prefilter_wgsl::declarations(text);
    own.retain(|declaration| may_be_built_in(declaration.name));
    modules.iter().try_for_each(|module| hides_nothing(path, &own, module))?;
    // The user's text may have replaced what a driver's text declares, and with it what functions of modules mean.
    let replaceable = modules.iter().any(|module| !module.foreign.is_empty());
    if modules.is_empty() || replaceable {
        return Shader::new(path, linked);
    }
    Shader::joined(path, linked, modules)
}

fn validator() -> Validator {
    Validator::new(ValidationFlags::all(), Capabilities::empty())
}

/// Refuses two modules whose drivers' texts declare one name differently: one of them would call the other's.
fn shares_nothing(module: &Module, other: &Module) -> Result<(), Error> {
    let known = prefilter_wgsl::declarations(&other.foreign);
    let differs = |own: &prefilter_wgsl::Declaration<'_>| {
        known.iter().any(|known| known.name == own.name && known.text.trim() != own.text.trim())
    };
    match prefilter_wgsl::declarations(&module.foreign).into_iter().find(differs) {
        None => Ok(()),
        Some(own) => {
            let (name, first, second) = (own.name, &other.name, &module.name);
            Err(Error::Conflict(format!("the drivers of `{first}` and `{second}` declare `{name}` differently")))
        }
    }
}

/// Adds the declarations of a text whose names are not declared yet.
fn add_foreign(whole: &mut String, text: &str) {
    if text.is_empty() {
        return;
    }
    let mut known: BTreeSet<String> =
        prefilter_wgsl::declarations(whole).into_iter().map(|known| known.name.to_owned()).collect();
    for declaration in prefilter_wgsl::declarations(text) {
        if known.insert(declaration.name.to_owned()) {
            whole.push_str(&format!("\n{}\n", declaration.text));
        }
    }
}

/// Refuses a text that declares a built-in which a module uses: the module would call the text's.
fn hides_nothing(path: &str, own: &[prefilter_wgsl::Declaration<'_>], module: &Module) -> Result<(), Error> {
    if !own
        .iter()
        .any(|declaration| written(&module.glue, declaration.name) || written(&module.foreign, declaration.name))
    {
        return Ok(());
    }
    let glue = [prefilter_wgsl::declarations(&module.glue), prefilter_wgsl::declarations(&module.foreign)].concat();
    let used: BTreeSet<&str> = glue.iter().flat_map(|declaration| declaration.free()).collect();
    let built_in = |name: &str| used.contains(name) && !glue.iter().any(|declaration| declaration.name == name);
    match own.iter().find(|declaration| built_in(declaration.name)) {
        None => Ok(()),
        Some(prefilter_wgsl::Declaration { name, line, column, .. }) => {
            let user = &module.name;
            let hidden = "is declared here and hides the built-in that the module";
            Err(Error::Shader {
                message: format!("{path}:{line}:{column}: `{name}` {hidden} `{user}` uses; rename yours"),
            })
        }
    }
}

/// Whether the language may have the name itself: of those with a low line only types of textures and samplers.
fn may_be_built_in(name: &str) -> bool {
    !name.contains('_') || name.starts_with("texture_") || name.starts_with("sampler_")
}

/// Whether a text has a name, were it in a comment.
fn written(text: &str, name: &str) -> bool {
    let part = |letter: Option<char>| letter.is_some_and(|letter| letter.is_alphanumeric() || letter == '_');
    let mut places = text.match_indices(name);
    places.any(|(at, _)| !part(text[..at].chars().next_back()) && !part(text[at + name.len()..].chars().next()))
}

/// naga's message with the nearest name of the text or the shelf below an unknown one.
fn with_hint(message: &str, text: &str) -> String {
    let unknown =
        message.split("no definition in scope for identifier: `").nth(1).and_then(|rest| rest.split('`').next());
    match unknown.and_then(|name| prefilter_wgsl::nearest(name, text)) {
        Some(near) => format!("{}\n= help: did you mean `{near}`?", message.trim_end()),
        None => message.trim_end().to_owned(),
    }
}

fn refused(path: &str, place: Option<naga::SourceLocation>, message: &str) -> Error {
    let place = place.map_or(String::new(), |place| format!(":{}:{}", place.line_number, place.line_position));
    Error::Shader { message: format!("{path}{place}: {message}") }
}

fn backend(language: &'static str, error: &dyn std::error::Error) -> Error {
    Error::Backend { language, message: error.to_string() }
}
