//! Runs an export of a module on a device over many points.

use prefilter::gpu::{Address, Device, Dispatch, Kernel, Texture, Work};
use prefilter::{Export, Module};

/// A module's export as a kernel: the numbers of a point in, a color out.
#[derive(Clone, Debug)]
pub struct ExportKernel {
    kernel: Kernel,
    textures: Vec<Texture>,
    export: Export,
    width: usize,
}

impl ExportKernel {
    /// The export with those of the module's own tables that it takes, clamped at their edges.
    ///
    /// # Errors
    /// What the module or the device refuses.
    pub fn new(device: &Device, module: &Module, export: &Export) -> Result<Self, prefilter::Error> {
        Self::linked(device, &[module], "", export)
    }

    /// A function of a text before modules, whose exports and tables it may take.
    ///
    /// # Errors
    /// A text without the function, what modules or the device refuse.
    pub fn before(device: &Device, modules: &[&Module], text: &str, function: &str) -> Result<Self, prefilter::Error> {
        Self::linked(device, modules, text, &declared(text, function)?)
    }

    fn linked(device: &Device, modules: &[&Module], text: &str, export: &Export) -> Result<Self, prefilter::Error> {
        let taken = |name: &str| export.parameters().iter().any(|(parameter, _)| *parameter == name);
        let tables = modules.iter().flat_map(|module| module.tables()).filter(|table| taken(&table.name));
        let textures = tables.map(|table| device.upload(table, Address::Clamp));
        let (entry, width) = entry(export);
        let shader = prefilter::link(modules, &format!("{entry}\n{text}"))?;
        let kernel = Kernel::new(device, shader.wgsl(), "main")?;
        Ok(Self { kernel, textures: textures.collect::<Result<_, _>>()?, export: export.clone(), width })
    }

    /// Name and type of each parameter, in order.
    pub fn parameters(&self) -> Vec<(&str, &str)> {
        self.export.parameters()
    }

    /// The colors at the points, whose numbers follow each other; unused channels are 0.
    ///
    /// # Errors
    /// What the device refuses.
    pub fn run(&self, points: &[f32]) -> Result<Vec<[f32; 4]>, prefilter::Error> {
        let output = self.prepare(points)?.run()?;
        Ok(output.chunks_exact(4).map(|color| [color[0], color[1], color[2], color[3]]).collect())
    }

    /// The same, to run or to time once or many times.
    ///
    /// # Errors
    /// What the device refuses.
    pub fn prepare(&self, points: &[f32]) -> Result<Dispatch, prefilter::Error> {
        let textures: Vec<&Texture> = self.textures.iter().collect();
        let invocations = points.len() / self.width;
        let work = Work { inputs: &[points], textures: &textures, invocations, output: 4 * invocations };
        self.kernel.prepare(&work)
    }
}

/// A function of a text as an export.
fn declared(text: &str, function: &str) -> Result<Export, prefilter::Error> {
    let declarations = prefilter_wgsl::declarations(text);
    let Some(found) = declarations.into_iter().find(|declaration| declaration.name == function) else {
        return Err(prefilter::Error::Conflict(format!("the text has no function `{function}`")));
    };
    let (name, documentation) = (found.name.to_owned(), found.documentation());
    Ok(Export { name, signature: found.signature, documentation })
}

/// A compute shader that calls the export once an invocation, and how many numbers a point has.
fn entry(export: &Export) -> (String, usize) {
    let (mut bindings, mut arguments) = (String::new(), Vec::new());
    let (mut slot, mut width) = (0, 0);
    for (name, kind) in export.parameters() {
        match kind {
            "sampler" => {
                bindings += &format!("@group(1) @binding({}) var {name}: sampler;\n", slot - 1);
                arguments.push(name.to_owned());
            }
            "texture_2d<f32>" | "texture_3d<f32>" => {
                bindings += &format!("@group(1) @binding({slot}) var {name}: {kind};\n");
                slot += 2;
                arguments.push(name.to_owned());
            }
            _ => {
                let count = match kind {
                    "vec2f" => 2,
                    "vec3f" => 3,
                    "vec4f" => 4,
                    _ => 1,
                };
                let numbers: Vec<String> = (width..width + count).map(|at| format!("values[at + {at}u]")).collect();
                arguments.push(format!("{kind}({})", numbers.join(", ")));
                width += count;
            }
        }
    }
    let call = format!("{}({})", export.name, arguments.join(", "));
    let color = if export.result() == "vec3f" { format!("vec4f({call}, 0.0)") } else { format!("vec4f({call})") };
    let text = format!(
        "@group(0) @binding(0) var<storage, read_write> colors: array<vec4f>;
@group(0) @binding(1) var<storage, read> values: array<f32>;
{bindings}
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {{
    let index = id.x + id.y * groups.x * 64u;
    if index < arrayLength(&colors) {{
        let at = index * {width}u;
        colors[index] = {color};
    }}
}}
"
    );
    (text, width)
}
