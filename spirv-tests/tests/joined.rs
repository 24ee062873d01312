//! Links take the functions of modules as they were parsed for those: is the module what naga parses from the text?

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;

use naga::back::wgsl::{write_string, WriterFlags};
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{Block, Function, Span, Statement};
use prefilter::{link, Module, Shader, Stage};
use prefilter_wgsl::FILES;
use spirv_tests::scenes;

type Outcome = Result<(), Box<dyn Error + Send + Sync>>;

/// A module's declarations by their names, as naga writes them: in which order it has them does not matter, nor do the
/// numbers behind a low line by which naga tells equal names of different functions apart.
fn declarations(module: &naga::Module, info: &ModuleInfo) -> Result<BTreeMap<String, String>, naga::back::wgsl::Error> {
    let text = write_string(module, info, WriterFlags::EXPLICIT_TYPES)?;
    let declarations = prefilter_wgsl::declarations(&text);
    Ok(declarations.iter().map(|one| (one.name.to_owned(), unnumbered(one.text.trim()))).collect())
}

fn unnumbered(text: &str) -> String {
    let mut parts = text.split('_');
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |whole, part| match part.trim_start_matches(|digit: char| digit.is_ascii_digit()) {
        rest if rest.len() < part.len() => whole + rest,
        _ => whole + "_" + part,
    })
}

/// The places in the text of each function, its expressions and variables, and its statements.
fn places(module: &naga::Module) -> BTreeMap<&str, Vec<Span>> {
    let of = |function: &Function| {
        let mut spans: Vec<Span> =
            function.expressions.iter().map(|(at, _)| function.expressions.get_span(at)).collect();
        spans.extend(function.local_variables.iter().map(|(at, _)| function.local_variables.get_span(at)));
        statements(&function.body, &mut spans);
        spans
    };
    let functions = module.functions.iter().filter_map(|(at, function)| {
        let own = module.functions.get_span(at);
        Some((function.name.as_deref()?, [vec![own], of(function)].concat()))
    });
    functions.chain(module.entry_points.iter().map(|point| (point.name.as_str(), of(&point.function)))).collect()
}

fn statements(block: &Block, spans: &mut Vec<Span>) {
    for (statement, span) in block.span_iter() {
        spans.push(*span);
        match statement {
            Statement::Block(block) => statements(block, spans),
            Statement::If { accept, reject, .. } => {
                [accept, reject].into_iter().for_each(|block| statements(block, spans))
            }
            Statement::Switch { cases, .. } => cases.iter().for_each(|case| statements(&case.body, spans)),
            Statement::Loop { body, continuing, .. } => {
                [body, continuing].into_iter().for_each(|block| statements(block, spans))
            }
            _ => (),
        }
    }
}

fn assert_same(name: &str, shader: &Shader) -> Outcome {
    let parsed = naga::front::wgsl::parse_str(shader.wgsl())?;
    let info = Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(&parsed)?;
    let (module, own) = shader.naga();
    assert_eq!(declarations(module, own)?, declarations(&parsed, &info)?, "{name}");
    assert_eq!(places(module), places(&parsed), "{name}");
    let filters =
        |module: &naga::Module| module.functions.iter().filter(|(_, one)| one.diagnostic_filter_leaf.is_some()).count();
    assert_eq!(filters(module), filters(&parsed), "{name}");
    Ok(())
}

#[test]
fn a_module_behind_a_text_is_what_naga_parses() -> Outcome {
    for (name, scene) in scenes::all()? {
        let module = scene.module()?;
        for stage in [Stage::Fragment, Stage::Compute] {
            assert_same(name, &module.link(&module.probe(stage))?)?;
        }
    }
    Ok(())
}

/// Whether nothing of a module is a driver's own text, behind which all is parsed again.
fn without_foreign(module: &Module) -> bool {
    let shelf: BTreeSet<&str> =
        FILES.iter().flat_map(|file| prefilter_wgsl::declarations(file.text)).map(|one| one.name).collect();
    let declarations = prefilter_wgsl::declarations(module.wgsl());
    declarations.iter().all(|one| one.name.starts_with(module.name()) || shelf.contains(one.name))
}

#[test]
fn all_modules_in_one_text_are_what_naga_parses() -> Outcome {
    let mut modules: BTreeMap<String, Module> = BTreeMap::new();
    for (_, scene) in scenes::all()? {
        let module = scene.module()?;
        if without_foreign(&module) {
            modules.insert(module.name().to_owned(), module);
        }
    }
    let modules: Vec<&Module> = modules.values().collect();
    let text =
        "diagnostic(off, derivative_uniformity);\nfn own(x: f32) -> f32 { return normal_cdf(split_single * x); }\n";
    assert!(modules.len() > 9, "{}", modules.len());
    assert_same("all", &link(&modules, text)?)
}
