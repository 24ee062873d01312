//! What functions cost, in multiply-adds, beside what they count as where tiers are chosen.

use crate::report::document::{Cell, Item, Table};
use crate::report::timing::{fastest, filling, repeated, SHORT};
use crate::report::{Bench, Error};
use prefilter::gpu::{Address, Dispatch, Kernel, Texture, Work};
use prefilter::table::{Format, Level, Sampling};

/// Kernels, and times.
pub const STEPS: u64 = 2;

/// At least so many invocations are timed, of a loop of so many turns of four statements.
const INVOCATIONS: usize = 1 << 12;
const LOOPS: usize = 16;
const STATEMENTS: usize = 4;

/// Expressions of a vector v of four numbers between 0.3 and 2.
const FUNCTIONS: [(&str, &str); 18] = [
    ("sum", "v + given"),
    ("min", "min(v, given)"),
    ("comparison and choice", "select(v, given, v < given)"),
    ("exp2", "exp2(v)"),
    ("log2", "log2(v)"),
    ("sqrt", "sqrt(v)"),
    ("inverseSqrt", "inverseSqrt(v)"),
    ("1/x", "1.0 / v"),
    ("x/y", "given / v"),
    ("exp", "exp(v)"),
    ("log", "log(v)"),
    ("sin", "sin(v)"),
    ("tanh", "tanh(v)"),
    ("pow", "pow(v, given)"),
    ("atan", "atan(v)"),
    ("atan2", "atan2(v, given)"),
    ("asin", "asin(0.4 * v)"),
    ("smoothstep", "smoothstep(vec4f(), given, v)"),
];

/// Reads of four halves, which are one fetch.
const FETCHES: [(&str, &str); 3] = [
    ("filtered fetch, 64 × 16", "textureSampleLevel(plane, plane_sampler, v.xy, 0.0)"),
    ("filtered fetch, 64 × 64 × 16", "textureSampleLevel(volume, volume_sampler, v.xyz, 0.0)"),
    ("fetch of a texel", "textureLoad(plane, vec2i(v.xy * 8.0), 0)"),
];

/// A kernel whose loop has some statements.
fn text(statements: &str) -> String {
    format!(
        "@group(0) @binding(0) var<storage, read_write> sums: array<vec4f>;
@group(0) @binding(1) var<storage, read> numbers: array<vec4f>;
@group(1) @binding(0) var plane: texture_2d<f32>;
@group(1) @binding(1) var plane_sampler: sampler;
@group(1) @binding(2) var volume: texture_3d<f32>;
@group(1) @binding(3) var volume_sampler: sampler;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {{
    var v = numbers[id.x];
    let scale = numbers[0].xxxx * 0.1;
    let offset = numbers[1].xxxx * 0.4;
    let given = numbers[2] * 0.9;
    for (var turn = 0u; turn < {LOOPS}u; turn++) {{
{statements}    }}
    sums[id.x] = v;
}}
"
    )
}

/// So many statements of multiply-adds about an expression.
fn statements(expression: &str, count: usize) -> String {
    format!("        v = fma({expression}, scale, offset);\n").repeat(count)
}

fn table(name: &str, [width, height, depth]: [u32; 3]) -> prefilter::Table {
    let count = (width * height * depth) as usize;
    let texels = (0..4 * count).map(|at| 0.5 + 0.4 * ((at as f32 * 0.618_034).fract() - 0.5)).collect();
    let level = Level { width, height, depth, texels };
    prefilter::Table {
        name: name.to_owned(),
        levels: vec![level],
        format: Format::Rgba16Float,
        sampling: Sampling::Filtered,
        error: 0.0,
    }
}

/// What an expression of four numbers counts as, and a fetch.
fn weight(expression: &str, fetch: bool) -> Result<f64, Error> {
    if fetch {
        let one = prefilter::Cost { fetches: 1, ..prefilter::Cost::default() };
        return Ok(one.weight() as f64);
    }
    let text = format!("fn judged(v: vec4f, given: vec4f) -> vec4f {{ return {expression}; }}");
    let cost = prefilter::link(&[], &text)?.cost("judged").unwrap_or_default();
    Ok(cost.weight() as f64 / 4.0)
}

/// The measured costs of all functions.
pub fn items(bench: &Bench<'_>) -> Result<Vec<Item>, Error> {
    let textures = [table("plane", [64, 16, 1]), table("volume", [64, 64, 16])];
    let textures: Vec<Texture> =
        textures.iter().map(|table| bench.timed.upload(table, Address::Mirror)).collect::<Result<_, _>>()?;
    let textures: Vec<&Texture> = textures.iter().collect();
    let numbers: Vec<f32> = (0..4 * INVOCATIONS).map(|at| 0.9 + 0.2 * (at as f32 * 0.754_878).fract()).collect();
    let over = |kernel: &Kernel, count: usize| {
        let numbers = repeated(&numbers, INVOCATIONS, count);
        kernel.prepare(&Work { inputs: &[&numbers], textures: &textures, invocations: count, output: 4 * count })
    };
    let kernel = |statements: &str| Kernel::new(bench.timed, &text(statements), "main");
    let bare = kernel(&statements("v", STATEMENTS))?;
    // Times are compared by their differences: all are of as many as fill the device with the least to do.
    let (bare, invocations) = filling(INVOCATIONS, SHORT, |count| over(&bare, count))?;
    let dispatch = |statements: &str| -> Result<Dispatch, Error> { Ok(over(&kernel(statements)?, invocations)?) };
    let all: Vec<(&str, &str, bool)> = FUNCTIONS
        .map(|(name, expression)| (name, expression, false))
        .into_iter()
        .chain(FETCHES.map(|(name, expression)| (name, expression, true)))
        .collect();
    let mut dispatches = vec![bare, dispatch(&statements("v", 5 * STATEMENTS))?];
    for (_, expression, _) in &all {
        dispatches.push(dispatch(&statements(expression, STATEMENTS))?);
    }
    (bench.done)(1);
    let seconds = fastest(&dispatches, bench.extent)?;
    (bench.done)(1);
    // Four times as many multiply-adds more are four to each of the statements.
    let each = (seconds[1] - seconds[0]) / 4.0;
    let mut rows = Vec::new();
    for ((name, expression, fetch), seconds_of) in all.into_iter().zip(&seconds[2..]) {
        let measured = (seconds_of - seconds[0]) / each * if fetch { 4.0 } else { 1.0 };
        rows.push(vec![name.into(), Cell::Number(weight(expression, fetch)?), Cell::Number(measured)]);
    }
    let caption =
        "Functions of one number in multiply-adds: what they count as where the lightest tier is chosen, and \
        what they take here, in chains of four numbers at a time; fetches are of four halves.";
    let columns = ["function", "counts as", "measured"].map(str::to_owned).to_vec();
    Ok(vec![Item::Table(Table { stem: "costs_functions".to_owned(), caption: caption.to_owned(), columns, rows })])
}
