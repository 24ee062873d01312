//! Height transfers between a driver and a filter: the moments of a curve over what a footprint holds, as WGSL.

use crate::accuracy::Ranges;
use crate::table::transfer::Plan;
use crate::table::{power, Table};
use crate::transfer::height_transfer::HeightTransfer;
use crate::transfer::polynomial::Piece;
use crate::Error;

/// What to call the table.
const TABLE: &str = "transfer";

/// The largest height and slope of a preconvolved curve.
const LARGEST: f64 = 1e18;

/// The WGSL function `NAME_transferred(mean: f32, deviation: f32) -> vec4f`, which returns mean and variance of h =
/// g(f) and of the slope g′(f) over a normal f, piece by piece in closed form; none for a power other than 1, 2 and 3.
///
/// The mean of h is where a displaced vertex belongs, so that geometry and shading agree at every distance. Values and
/// slopes are within 1e-4 of their ranges, variances of the squared ranges, for deviations from 1e-4 to 10 times the
/// part of the values over which the curve changes.
///
/// ```
/// use prefilter::{driver::transfer, HeightTransfer};
/// let text = transfer::closed("moss", &HeightTransfer::smoothstep(0.0, 1.2)?).unwrap_or_default();
/// assert!(text.contains("fn moss_transferred(mean: f32, deviation: f32) -> vec4f"));
/// assert!(prefilter::link(&[], &text)?.wgsl().contains("fn cubic_piece"));
/// # Ok::<(), prefilter::Error>(())
/// ```
pub fn closed(name: &str, curve: &HeightTransfer) -> Option<String> {
    let pieces = curve.pieces()?;
    let body = match pieces {
        [Piece { coefficients, .. }] => {
            format!("    return piece_whole(mean, deviation, vec4f({}));\n", list(coefficients))
        }
        pieces => sum(pieces),
    };
    Some(documented(name, "", &body))
}

/// [`closed`] for every curve of pieces, else a function of the same name that also takes a table, with that table: a
/// power takes `transfer: texture_2d<f32>` with one row, within 1e-4 of all means and deviations.
///
/// A call counts some 300 operations a piece: many are dear, but no table sees bends under a narrow footprint.
pub fn stage(name: &str, curve: &HeightTransfer) -> (String, Vec<Table>) {
    if let Some(text) = closed(name, curve) {
        return (text, Vec::new());
    }
    let (parameters, body, table) = powered(curve, curve.exponent().unwrap_or(1.0));
    (documented(name, parameters, &body), vec![table])
}

/// The paper's preconvolved texture, whatever the curve: `NAME_transferred` that takes `transfer: texture_2d<f32>,
/// transfer_sampler: sampler`, with that table, over the ranges of f. To compare with.
///
/// Source: Heitz, Nowrouzezahrai, Poulin and Neyret 2014, "Filtering Non-Linear Transfer Functions on Surfaces",
/// section 7, with deviations in place of second moments.
///
/// # Errors
/// Ranges that a scene refuses, and those over which the curve reaches heights or slopes beyond 1e18, whose squares are
/// beyond what floats hold.
pub fn preconvolved(name: &str, curve: &HeightTransfer, ranges: &Ranges) -> Result<(String, Table), Error> {
    ranges.check()?;
    let plan = Plan::new(curve, ranges.mean, ranges.deviation);
    for (what, value) in ["the highest height of a curve", "its steepest slope"].into_iter().zip(plan.largest()) {
        if !(value <= LARGEST) {
            return Err(Error::value(what, value as f32, format!("at most {LARGEST:e} over all values that occur")));
        }
    }
    let (parameters, body, table) = tabulated(plan, ranges);
    Ok((documented(name, parameters, &body), table))
}

/// The WGSL function `NAME_narrow(mean: f32, deviation: f32, …) -> vec2f`, which returns mean and deviation of h over a
/// normal f that is narrow beside the pieces of the curve, and takes the tables that [`stage`] does: a sixth of the
/// operations of all moments. At a crease mean and deviation err by up to 0.06 and 0.08 deviations of f times the
/// change of the slope.
pub fn narrow(name: &str, curve: &HeightTransfer) -> String {
    let (parameters, body) = match curve.pieces() {
        Some(pieces) => ("", narrow_pieces(pieces)),
        None => {
            let moments = format!("    let m = {name}_transferred(mean, deviation, {TABLE});\n");
            (", transfer: texture_2d<f32>", moments + "    return vec2f(m.x, sqrt(m.y));\n")
        }
    };
    format!(
        "
/// Mean and deviation of the height g(f) over a normal f that is narrow beside what the curve bends over.
fn {name}_narrow(mean: f32, deviation: f32{parameters}) -> vec2f {{
{body}}}
"
    )
}

/// The statements that return mean and deviation of the heights of pieces.
fn narrow_pieces(pieces: &[Piece]) -> String {
    let mut body = "    let at = transfer_places(mean, deviation);\n".to_owned();
    for (index, piece) in pieces.iter().enumerate() {
        let heights = heights(piece);
        body += &match index {
            0 => format!("    var h = {heights};\n"),
            _ => format!("    h = select(h, {heights}, at >= vec4f({}));\n", number(piece.from)),
        };
    }
    body + "    return transfer_heights(h);\n"
}

/// A piece's heights at four values named `at`.
fn heights(piece: &Piece) -> String {
    let [constant, linear, square, cube] = piece.coefficients;
    let constant = number(constant);
    let place = place("at", piece);
    match () {
        () if [linear, square, cube] == [0.0; 3] => format!("vec4f({constant})"),
        () if [square, cube] == [0.0; 2] => format!("{constant} + {place} * {}", number(linear)),
        () => format!("transfer_cubic({place}, vec4f({}))", list(&piece.coefficients)),
    }
}

/// A power: its parameters beside mean and deviation, its body and its table.
fn powered(curve: &HeightTransfer, exponent: f64) -> (&'static str, String, Table) {
    let [amplitude, offset] = curve.scale();
    let body = format!(
        "    let read = transfer_power(mean, deviation, {}, transfer);
    return vec4f({}) * read + vec4f({}, 0.0, 0.0, 0.0);
",
        number(exponent),
        list(&[amplitude, amplitude * amplitude, amplitude, amplitude * amplitude]),
        number(offset)
    );
    (", transfer: texture_2d<f32>", body, power::table(TABLE, exponent))
}

/// A curve by its preconvolved texture: the same.
fn tabulated(plan: Plan<'_>, ranges: &Ranges) -> (&'static str, String, Table) {
    let ends = list(&[ranges.mean.0, ranges.mean.1, ranges.deviation].map(f64::from));
    let [height, slope] = plan.radii;
    let body = format!(
        "    let read = transfer_table(mean, deviation, {ends}, transfer, transfer_sampler);
    return vec4f({}) * read + vec4f({});
",
        list(&[height, height * height, slope, slope * slope]),
        list(&[plan.middles[0], 0.0, plan.middles[1], 0.0])
    );
    (", transfer: texture_2d<f32>, transfer_sampler: sampler", body, plan.table(TABLE))
}

/// The function of a name with these parameters beside mean and deviation.
fn documented(name: &str, parameters: &str, body: &str) -> String {
    format!(
        "/// Mean and variance of the height g(f), and of the slope g'(f), over a normal f with this mean and deviation.
fn {name}_transferred(mean: f32, deviation: f32{parameters}) -> vec4f {{
{body}}}
"
    )
}

/// The statements that return the moments of two pieces or more.
fn sum(pieces: &[Piece]) -> String {
    // Below a millionth of the longest piece, on which all pieces must agree where one ends.
    let floor = 1e-6 * pieces.iter().map(|piece| piece.unit).fold(0.0, f64::max);
    let mut body = format!("    let s = max(deviation, {});\n    let inverse = 1.0 / s;\n", number(floor));
    body += "    // The height and the slope at the mean, about which all is summed up.\n";
    for (index, piece) in pieces.iter().enumerate() {
        let at = at(piece);
        body += &match index {
            0 => format!("    var about = {at};\n"),
            _ => format!("    about = select(about, {at}, mean >= {});\n", number(piece.from)),
        };
    }
    for (index, piece) in pieces.iter().enumerate() {
        let assigned = if index == 0 { "var sum =" } else { "sum +=" };
        body += &format!("    {assigned} {};\n", part(piece));
    }
    body + "    return piece_statistics(sum, about);\n"
}

/// A piece's height and slope at the mean.
fn at(piece: &Piece) -> String {
    let [constant, linear, square, cube] = piece.coefficients;
    let place = place("mean", piece);
    let scale = 1.0 / piece.unit;
    match () {
        () if [linear, square, cube] == [0.0; 3] => format!("vec2f({})", list(&[constant, 0.0])),
        () if [square, cube] == [0.0; 2] => {
            let [constant, linear, slope] = [constant, linear, linear * scale].map(number);
            format!("vec2f({constant} + {place} * {linear}, {slope})")
        }
        () => {
            let scaled = if piece.unit == 1.0 { String::new() } else { format!(" * vec2f(1.0, {})", number(scale)) };
            format!("piece_curve({place}, vec4f({})){scaled}", list(&piece.coefficients))
        }
    }
}

/// What a piece adds.
fn part(piece: &Piece) -> String {
    let [constant, linear, square, cube] = piece.coefficients;
    let end = |value: f64| format!("({}) * inverse", from(value, "mean"));
    if [linear, square, cube] == [0.0; 3] {
        let low = if piece.from.is_finite() { end(piece.from) } else { "-12.0".into() };
        let high = if piece.to.is_finite() { end(piece.to) } else { "12.0".into() };
        return format!("piece_flat({low}, {high}, vec2f({}) - about)", list(&[constant, 0.0]));
    }
    if piece.from == f64::NEG_INFINITY {
        let mirrored = list(&[constant, -linear, square]);
        let distance = from(piece.origin, "mean");
        let part = format!("piece_half({distance}, s, vec3f({mirrored}), about * vec2f(1.0, -1.0))");
        return format!("vec4f(1.0, 1.0, -1.0, 1.0) * {part}");
    }
    if piece.to == f64::INFINITY {
        return format!("piece_half({}, s, vec3f({}), about)", place("mean", piece), list(&[constant, linear, square]));
    }
    let scale = 1.0 / piece.unit;
    let called = if [square, cube] == [0.0; 2] {
        format!("piece_line({}, s * {}, vec2f({}),", place("mean", piece), number(scale), list(&[constant, linear]))
    } else {
        format!("cubic_piece({}, s * {}, vec4f({}),", place("mean", piece), number(scale), list(&piece.coefficients))
    };
    if piece.unit == 1.0 {
        return format!("{called} about)");
    }
    let slopes = list(&[1.0, 1.0, scale, scale * scale]);
    format!("vec4f({slopes}) * {called} about * vec2f(1.0, {}))", number(piece.unit))
}

/// A value in the unit of a piece.
fn place(value: &str, piece: &Piece) -> String {
    let distance = match piece.origin {
        0.0 => value.to_owned(),
        origin if origin < 0.0 => format!("({value} + {})", number(-origin)),
        origin => format!("({value} - {})", number(origin)),
    };
    if piece.unit == 1.0 {
        distance
    } else {
        format!("{distance} * {}", number(1.0 / piece.unit))
    }
}

/// A number less a name.
fn from(value: f64, less: &str) -> String {
    if value == 0.0 {
        format!("-{less}")
    } else {
        format!("{} - {less}", number(value))
    }
}

fn list(values: &[f64]) -> String {
    values.iter().map(|&value| number(value)).collect::<Vec<_>>().join(", ")
}

/// A literal of the nearest f32; abstract floats need a point or an exponent.
fn number(value: f64) -> String {
    let value = value as f32;
    format!("{:?}", if value == 0.0 { 0.0 } else { value })
}
