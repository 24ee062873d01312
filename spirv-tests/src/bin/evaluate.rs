//! Evaluates one shelf function on the device.
#![deny(missing_docs)]

use std::io::{self, BufRead, BufWriter, Write};
use std::process::ExitCode;

use clap::Parser;
use prefilter::gpu::Device;
use spirv_tests::kernel::Function;
use spirv_tests::signature::{Leaf, Scalar};

/// Evaluate a shelf function on the device: points on the standard input, results on the standard output.
///
/// A point is a line of numbers separated by spaces: the function's parameters in order, vectors number by number, true
/// as 1 and false as 0. Each gives a line with the numbers of the result, floats with 9 significant digits.
#[derive(Parser)]
struct Arguments {
    /// The function.
    #[arg(required_unless_present = "list")]
    function: Option<String>,
    /// Print the signature of every shelf function instead.
    #[arg(long, conflicts_with = "function")]
    list: bool,
}

fn main() -> ExitCode {
    let Arguments { function, list } = Arguments::parse();
    let mut output = BufWriter::new(io::stdout().lock());
    let done = match function {
        Some(name) if !list => evaluate(&name, &mut output),
        _ => listed(&mut output),
    };
    match done.and_then(|()| output.flush().map_err(written)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("evaluate: {error}");
            ExitCode::FAILURE
        }
    }
}

fn listed(output: &mut impl Write) -> Result<(), String> {
    Function::shelf()?.iter().try_for_each(|function| writeln!(output, "{}", function.declaration).map_err(written))
}

fn evaluate(name: &str, output: &mut impl Write) -> Result<(), String> {
    let functions = Function::shelf()?;
    let function = functions.iter().find(|function| function.name == name).ok_or_else(|| unknown(name, &functions))?;
    if function.signature.has_textures() {
        return Err(format!("`{name}` reads textures, which points cannot give: {}", function.declaration));
    }
    let inputs = function.signature.inputs();
    let mut points = Vec::new();
    for (number, line) in io::stdin().lock().lines().enumerate() {
        let line = line.map_err(|error| format!("line {}: {error}", number + 1))?;
        if !line.trim().is_empty() {
            points.push(point(&line, &inputs).map_err(|error| format!("line {}: {error}", number + 1))?);
        }
    }
    let device = Device::new().map_err(|error| error.to_string())?;
    let scalars: Vec<Scalar> = function.outputs().iter().map(|leaf| leaf.scalar).collect();
    for result in function.results(&device, &[], &points)? {
        let numbers: Vec<String> =
            result.iter().zip(&scalars).map(|(value, scalar)| printed(*value, *scalar)).collect();
        writeln!(output, "{}", numbers.join(" ")).map_err(written)?;
    }
    Ok(())
}

/// An unknown name, with the nearest function.
fn unknown(name: &str, functions: &[Function]) -> String {
    let near = prefilter_wgsl::nearest(name, "").filter(|near| functions.iter().any(|function| function.name == *near));
    let advice = near.map_or("see --list".to_owned(), |near| format!("did you mean `{near}`?"));
    format!("the shelf has no function `{name}`; {advice}")
}

/// The numbers of a line.
fn point(line: &str, inputs: &[Leaf]) -> Result<Vec<f64>, String> {
    let words: Vec<&str> = line.split_whitespace().collect();
    if words.len() != inputs.len() {
        let names: Vec<&str> = inputs.iter().map(|leaf| leaf.path.as_str()).collect();
        return Err(format!("{} numbers, expected {}: {}", words.len(), names.len(), names.join(" ")));
    }
    words.iter().zip(inputs).map(|(word, leaf)| number(word, leaf)).collect()
}

fn number(word: &str, leaf: &Leaf) -> Result<f64, String> {
    let refused = |kind: &str| format!("`{word}` for {} is no {kind}", leaf.path);
    match leaf.scalar {
        Scalar::Float => {
            let value: f32 = word.parse().map_err(|_| refused("number"))?;
            // Only words may be infinite: digits beyond the largest float are a slip.
            let beyond = value.is_infinite() && word.contains(|mark: char| mark.is_ascii_digit());
            if beyond {
                Err(refused("number that a 32-bit float holds"))
            } else {
                Ok(f64::from(value))
            }
        }
        Scalar::Signed => word.parse::<i32>().map(f64::from).map_err(|_| refused("32-bit integer")),
        Scalar::Unsigned => word.parse::<u32>().map(f64::from).map_err(|_| refused("unsigned 32-bit integer")),
        Scalar::Bool => match word {
            "0" | "false" => Ok(0.0),
            "1" | "true" => Ok(1.0),
            _ => Err(refused("truth value, 0 or 1")),
        },
    }
}

/// 9 significant digits tell every 32-bit float from its neighbors.
fn printed(value: f64, scalar: Scalar) -> String {
    match scalar {
        Scalar::Float if value.is_finite() => format!("{value:.8e}"),
        _ => format!("{value}"),
    }
}

fn written(error: io::Error) -> String {
    format!("writing the results: {error}")
}
