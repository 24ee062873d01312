//! Entry points that call every export of a module, so that a driver or a validator sees all of it.

use crate::module::{Export, Module, Stage};

/// The text of the entry point `main` with its bindings; arguments come from a buffer, so that nothing folds away.
pub(crate) fn probe(module: &Module, stage: Stage) -> String {
    let (space, head, tail) = match stage {
        Stage::Fragment => ("uniform", "@fragment\nfn main() -> @location(0) vec4f {", "    return sum;\n}\n"),
        Stage::Compute => (
            "storage",
            "@group(0) @binding(1) var<storage, read_write> result: array<vec4f>;\n\n\
             @compute @workgroup_size(1)\nfn main() {",
            "    result[0] = sum;\n}\n",
        ),
    };
    let count = module.exports.iter().map(|export| arguments(export).1).max().unwrap_or(0).max(1);
    let mut text = format!("struct Arguments {{\n    list: array<vec4f, {count}>,\n}}\n\n");
    text += &format!("@group(0) @binding(0) var<{space}> values: Arguments;\n");
    text += &bindings(module);
    text += &format!("{head}\n    var sum = vec4f(0.0);\n");
    for export in &module.exports {
        let call = format!("{}({})", export.name, arguments(export).0.join(", "));
        text += &match export.result() {
            "vec4f" => format!("    sum += {call};\n"),
            "vec3f" => format!("    sum += vec4f({call}, 0.0);\n"),
            _ => format!("    sum += vec4f({call});\n"),
        };
    }
    text + tail
}

/// The arguments of a call: numbers from the buffer, one vector each, tables by their own names.
fn arguments(export: &Export) -> (Vec<String>, usize) {
    let mut used = 0;
    let mut next = |parts: &str| {
        used += 1;
        format!("values.list[{}]{parts}", used - 1)
    };
    let argument = |(name, kind): (&str, &str)| match kind {
        "f32" => next(".x"),
        "vec2f" => next(".xy"),
        "vec3f" => next(".xyz"),
        "vec4f" => next(""),
        _ => name.to_owned(),
    };
    let list = export.parameters().into_iter().map(argument).collect();
    (list, used)
}

/// Textures and samplers, each once, in the order of the exports' parameters.
fn bindings(module: &Module) -> String {
    let mut bound: Vec<(&str, &str)> = Vec::new();
    for parameter in module.exports.iter().flat_map(Export::parameters) {
        let resource = parameter.1.starts_with("texture") || parameter.1 == "sampler";
        if resource && !bound.contains(&parameter) {
            bound.push(parameter);
        }
    }
    let line = |(binding, (name, kind)): (usize, &(&str, &str))| {
        format!("@group(1) @binding({binding}) var {name}: {kind};\n")
    };
    bound.iter().enumerate().map(line).collect()
}
