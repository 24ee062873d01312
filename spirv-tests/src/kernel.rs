//! One WGSL function as a compute kernel over points.

use std::fmt::Write;

use prefilter::gpu::{Device, Kernel, Texture, Work};

use crate::signature::{Leaf, Scalar, Shape, Signature};

/// A function of the shelf or of another text, with what it needs to run.
#[derive(Clone, Debug)]
pub struct Function {
    /// Its name.
    pub name: String,
    /// The file of the shelf that declares it; empty for another text.
    pub path: String,
    /// Its declaration without the body.
    pub declaration: String,
    /// Its `///` lines.
    pub documentation: String,
    /// Its parameters and result.
    pub signature: Signature,
    /// Its text with everything that it needs.
    text: String,
}

impl Function {
    /// Every function of the shelf, in the order of its files.
    ///
    /// # Errors
    /// A message where naga refuses one of them or one has no signature here.
    pub fn shelf() -> Result<Vec<Self>, String> {
        let functions = Self::declared().into_iter();
        functions.map(|(path, declaration)| Self::new(path, &declaration, String::new())?.with_makers()).collect()
    }

    /// One function of the shelf.
    ///
    /// # Errors
    /// A message where there is none of that name, or as [`Function::shelf`].
    pub fn of_shelf(name: &str) -> Result<Self, String> {
        let found = Self::declared().into_iter().find(|(_, declaration)| declaration.name == name);
        let (path, declaration) = found.ok_or_else(|| format!("the shelf has no function `{name}`"))?;
        Self::new(path, &declaration, String::new())?.with_makers()
    }

    /// The functions that the shelf declares, with their files.
    pub(crate) fn declared() -> Vec<(&'static str, prefilter_wgsl::Declaration<'static>)> {
        let files = prefilter_wgsl::FILES.iter();
        let declarations = files.flat_map(|file| {
            let declarations = prefilter_wgsl::declarations(file.text).into_iter();
            declarations.map(|declaration| (file.path, declaration))
        });
        declarations.filter(|(_, declaration)| declaration.kind == prefilter_wgsl::Kind::Function).collect()
    }

    /// The function of a text of one's own, which may mention the shelf.
    ///
    /// # Errors
    /// A message where the text cannot be linked, naga refuses it, or the function is not there.
    pub fn in_text(text: &str, name: &str) -> Result<Self, String> {
        let linked = prefilter_wgsl::link(text).map_err(|collision| collision.to_string())?;
        let declarations = prefilter_wgsl::declarations(text);
        let found = declarations.iter().find(|declaration| declaration.name == name);
        let found = found.ok_or_else(|| format!("the text has no function `{name}`"))?;
        Self::new("", found, linked)?.with_makers()
    }

    pub(crate) fn new(path: &str, declaration: &prefilter_wgsl::Declaration<'_>, text: String) -> Result<Self, String> {
        let text = if path.is_empty() { text } else { mentioned(declaration.name) };
        Ok(Self {
            name: declaration.name.to_owned(),
            path: path.to_owned(),
            // As on one line, where the shelf breaks the list of parameters.
            declaration: declaration.signature.replace("( ", "(").replace(", )", ")"),
            documentation: declaration.documentation(),
            signature: Signature::of(&text, declaration.name)?,
            text,
        })
    }

    /// Adds to the function's text what a function of the shelf needs besides.
    pub(crate) fn needs(&mut self, name: &str) {
        let needed = prefilter_wgsl::mentioned(name);
        let missing = needed.iter().filter(|(_, needed)| !self.text.contains(needed.text));
        let missing: String = missing.map(|(_, needed)| format!("{}\n\n", needed.text)).collect();
        self.text += &missing;
    }

    /// The numbers that the function returns, flattened.
    pub fn outputs(&self) -> Vec<Leaf> {
        self.signature.result.leaves("result")
    }

    /// The compute shader that calls the function once a point.
    pub fn kernel(&self) -> String {
        let (inputs, outputs) = (self.signature.inputs().len(), self.outputs());
        let mut text = String::from("@group(0) @binding(0) var<storage, read_write> kernel_output: array<u32>;\n");
        if inputs > 0 {
            text += "@group(0) @binding(1) var<storage, read> kernel_input: array<u32>;\n";
        }
        let arguments = self.arguments(&mut text);
        let store: String = outputs.iter().enumerate().fold(String::new(), |mut store, (number, leaf)| {
            let value = match leaf.scalar {
                Scalar::Float | Scalar::Signed => format!("bitcast<u32>({})", leaf.path),
                Scalar::Unsigned => leaf.path.clone(),
                Scalar::Bool => format!("select(0u, 1u, {})", leaf.path),
            };
            // Writing to a String cannot fail.
            let _ = writeln!(store, "    kernel_output[index * {}u + {number}u] = {value};", outputs.len());
            store
        });
        let _ = write!(
            text,
            "@compute @workgroup_size(64)
fn kernel_main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {{
    let index = id.x + id.y * groups.x * 64u;
    if index >= arrayLength(&kernel_output) / {count}u {{ return; }}
    let at = index * {inputs}u;
    let result = {name}({arguments});
{store}}}

{shelf}",
            count = outputs.len(),
            name = self.name,
            shelf = self.text
        );
        text
    }

    /// The arguments of the call; the bindings of textures and samplers go into the text.
    fn arguments(&self, text: &mut String) -> String {
        let mut next = 0;
        let mut number = |scalar: Scalar| {
            let bits = format!("kernel_input[at + {next}u]");
            next += 1;
            match scalar {
                Scalar::Float => format!("bitcast<f32>({bits})"),
                Scalar::Signed => format!("bitcast<i32>({bits})"),
                Scalar::Unsigned => bits,
                Scalar::Bool => format!("({bits} != 0u)"),
            }
        };
        let mut textures = 0usize;
        let arguments = self.signature.parameters.iter().map(|(name, shape)| {
            let (binding, kind) = match shape {
                Shape::Texture => (2 * textures, "texture_2d<f32>"),
                Shape::Volume => (2 * textures, "texture_3d<f32>"),
                // A sampler reads the texture before it.
                Shape::Sampler => ((2 * textures).saturating_sub(1), "sampler"),
                _ => return shape.construct(&mut number),
            };
            textures += usize::from(matches!(shape, Shape::Texture | Shape::Volume));
            let _ = writeln!(text, "@group(1) @binding({binding}) var kernel_{name}: {kind};");
            format!("kernel_{name}")
        });
        arguments.collect::<Vec<_>>().join(", ")
    }

    /// The results at the points, both flattened; a point or result is a list of numbers in order.
    ///
    /// # Errors
    /// A message where the device refuses the kernel.
    pub fn results(
        &self,
        device: &Device,
        textures: &[&Texture],
        points: &[Vec<f64>],
    ) -> Result<Vec<Vec<f64>>, String> {
        if points.is_empty() {
            return Ok(Vec::new());
        }
        let (inputs, outputs) = (self.signature.inputs(), self.outputs());
        let numbers =
            points.iter().flat_map(|point| point.iter().zip(&inputs).map(|(&x, leaf)| encode(x, leaf.scalar)));
        let numbers: Vec<f32> = numbers.collect();
        let lists: &[&[f32]] = if inputs.is_empty() { &[] } else { &[&numbers] };
        let kernel = Kernel::new(device, &self.kernel(), "kernel_main").map_err(|error| error.to_string())?;
        let output = points.len() * outputs.len();
        let work = Work { inputs: lists, textures, invocations: points.len(), output };
        let values = kernel.run(&work).map_err(|error| error.to_string())?;
        let decode = |chunk: &[f32]| chunk.iter().zip(&outputs).map(|(&x, leaf)| decode(x, leaf.scalar)).collect();
        Ok(values.chunks(outputs.len()).map(decode).collect())
    }
}

/// The declarations of the shelf that a text mentions, and what they need.
fn mentioned(text: &str) -> String {
    prefilter_wgsl::mentioned(text).iter().map(|(_, needed)| format!("{}\n\n", needed.text)).collect()
}

/// The 4 bytes of a number, carried as a float.
fn encode(value: f64, scalar: Scalar) -> f32 {
    match scalar {
        Scalar::Float => value as f32,
        Scalar::Signed => f32::from_bits(value as i32 as u32),
        Scalar::Unsigned => f32::from_bits(value as u32),
        Scalar::Bool => f32::from_bits(u32::from(value != 0.0)),
    }
}

/// The number that 4 bytes are.
fn decode(carried: f32, scalar: Scalar) -> f64 {
    match scalar {
        Scalar::Float => f64::from(carried),
        Scalar::Signed => f64::from(carried.to_bits() as i32),
        Scalar::Unsigned | Scalar::Bool => f64::from(carried.to_bits()),
    }
}
