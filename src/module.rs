//! What a scene becomes: text, tables, and what is known of them.

use std::collections::BTreeMap;

use crate::accuracy::Bound;
use crate::cost::Cost;
use crate::shader::{self, Shader};
use crate::table::Table;
use crate::{probe, Error};

/// A validated WGSL module of pure functions, with the tables that they read.
///
/// The text has no bindings and no entry points: the host wires. Paste it, include it, concatenate it, or [`link`] it
/// behind entry points of yours.
///
/// [`link`]: Module::link
#[derive(Clone, Debug)]
pub struct Module {
    pub(crate) name: String,
    pub(crate) glue: String,
    /// Declarations behind the glue that are its user's.
    pub(crate) foreign: String,
    pub(crate) linked: Shader,
    pub(crate) exports: Vec<Export>,
    pub(crate) tables: Vec<Table>,
    pub(crate) explanation: String,
    pub(crate) bound: Bound,
    /// Turns of the loops, by the names of their functions.
    pub(crate) turns: BTreeMap<String, usize>,
    pub(crate) cost: Cost,
}

/// A function of a module for its user to call.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Export {
    /// The function's name; it begins with the scene's.
    pub name: String,
    /// The WGSL signature on one line, from `fn` to the result's type.
    pub signature: String,
    /// What it does, in the words of the comment above it.
    pub documentation: String,
}

impl Export {
    /// Name and type of each parameter, in order.
    pub fn parameters(&self) -> Vec<(&str, &str)> {
        let list = self.signature.split_once('(').and_then(|(_, rest)| rest.rsplit_once(')'));
        list.map_or("", |(list, _)| list).split(", ").filter_map(|parameter| parameter.split_once(": ")).collect()
    }

    /// Whether it has a parameter of this name.
    pub(crate) fn takes(&self, name: &str) -> bool {
        self.parameters().iter().any(|(own, _)| *own == name)
    }

    /// The type that it returns.
    pub fn result(&self) -> &str {
        self.signature.rsplit_once("->").map_or("", |(_, kind)| kind.trim())
    }
}

impl Module {
    /// The scene's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The whole text: the exports first, the shelf functions that they need behind. The same scene gives the same
    /// bytes.
    pub fn wgsl(&self) -> &str {
        self.linked.wgsl()
    }

    /// The functions to call.
    pub fn exports(&self) -> &[Export] {
        &self.exports
    }

    /// The textures to bind, in the order of the exports' parameters.
    pub fn tables(&self) -> &[Table] {
        &self.tables
    }

    /// Which tier was chosen and why: its bound, its cost, those passed over, and what the bound does not cover.
    pub fn explain(&self) -> &str {
        &self.explanation
    }

    /// The largest error of a channel over the scene's ranges.
    pub fn bound(&self) -> Bound {
        self.bound
    }

    /// What one call of the most expensive export costs.
    pub fn cost(&self) -> Cost {
        self.cost
    }

    /// Your text with this module and the shelf functions that both mention behind it, validated.
    ///
    /// The text comes first, so that line numbers in messages are its own. It may mention shelf functions too. To link
    /// several modules, see [`link`](crate::link).
    ///
    /// # Errors
    /// A text that declares a name of the shelf or of the module, or that naga refuses: the message has line, column
    /// and excerpt, and for an unknown name the nearest known.
    pub fn link(&self, text: &str) -> Result<Shader, Error> {
        shader::link(&[self], text)
    }

    /// The module as a SPIR-V library, version 1.3: each export is decorated with `LinkageAttributes`, so that a linker
    /// such as `spirv-link` finds it by its name.
    ///
    /// A Vulkan shader comes from [`Self::link`] instead: it needs an entry point.
    ///
    /// # Errors
    /// What naga's writer refuses.
    pub fn spirv(&self) -> Result<Vec<u32>, Error> {
        let names: Vec<&str> = self.exports.iter().map(|export| export.name.as_str()).collect();
        self.linked.spirv_exporting(&names)
    }

    /// A text with one entry point that calls every export with arguments from a buffer: to link and hand to a driver
    /// or a validator.
    pub fn probe(&self, stage: Stage) -> String {
        probe::probe(self, stage)
    }
}

/// The stage of a [`Module::probe`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stage {
    /// A fragment shader: arguments from a uniform buffer, the results in a color.
    Fragment,
    /// A compute shader: arguments and results in storage buffers.
    Compute,
}
