//! Pyramids of images in hard cases: what they read, against the image itself.

use prefilter::gpu::{Address, Device, Texture};
use prefilter::reference::four_moments::Raw;
use prefilter::reference::moments::{Beyond, Image};
use prefilter::reference::slope_moments::Slopes;
use prefilter::table::{Format, Table};
use prefilter::{Edge, Error, FourMomentMipmap, MomentMipmap, SlopeMipmap};

use super::cases::Case;
use super::drivers::Source;
use super::footprints::Footprint;
use super::outcome::Outcome;
use crate::kernel::Function;

/// Texels of a side of the image.
const SIDE: usize = 32;

/// Eleven bits of values up to 1.
const HALVES: f64 = 5e-4;

/// An image, which repeats: waves, two halves, or a column of one texel; of slopes the same along y turned.
struct Sample {
    side: usize,
    values: Vec<f32>,
    image: Image,
}

/// The texels of a side in a case.
fn side(case: Case) -> usize {
    if case == Case::OneTexel {
        1
    } else {
        SIDE
    }
}

impl Sample {
    fn new(case: Case, turned: bool) -> Self {
        let value = |x: usize, y: usize| match case {
            Case::HardEdges => f32::from(u8::from(x < SIDE / 2)),
            Case::Stripes => f32::from(u8::from(x == SIDE / 2)),
            _ => {
                let (x, y) = (x as f32, y as f32);
                (0.5 + 0.3 * (0.7 * x).sin() * (0.4 * y).cos() + 0.15 * (1.9 * (x + y)).sin()).clamp(0.0, 1.0)
            }
        };
        let side = side(case);
        let place = |at: usize| if turned { (at / side, at % side) } else { (at % side, at / side) };
        let values: Vec<f32> = (0..side * side).map(place).map(|(x, y)| value(x, y)).collect();
        let exact = values.iter().copied().map(f64::from).collect();
        Self { side, values, image: Image { width: side, height: side, values: exact, beyond: Beyond::Repeat } }
    }

    fn texels<T>(&self, of: impl Fn(&Image, usize, usize) -> T) -> Vec<T> {
        (0..self.side * self.side).map(|at| of(&self.image, at % self.side, at / self.side)).collect()
    }
}

/// A truth: the first results of a read at a position with a covariance.
type Truth = Box<dyn Fn([f64; 2], [f64; 3]) -> Vec<f64>>;

/// The function of the shelf, its tables, and the truth.
fn reader(source: Source, case: Case) -> Result<(&'static str, Vec<Table>, Truth), Error> {
    let sample = Sample::new(case, false);
    let (side, halves) = (side(case) as u32, case == Case::HalfTables);
    let four = if halves { Format::Rgba16Float } else { Format::Rgba32Float };
    if source == Source::SlopeMoments {
        let other = Sample::new(case, true);
        let slopes: Vec<[f32; 2]> = sample.values.iter().zip(&other.values).map(|(x, y)| [*x, *y]).collect();
        let tables = SlopeMipmap::from_slopes(side, side, &slopes, Edge::Repeat)?.tables("slopes", four)?;
        let slopes = Slopes::new(sample.image, other.image);
        let truth = move |position, covariance| slopes.read(position, covariance).to_vec();
        return Ok(("slope_moments_read", tables.to_vec(), Box::new(truth)));
    }
    if source == Source::FourMoments {
        let image = FourMomentMipmap::new(side, side, &sample.values, Edge::Repeat)?;
        let texels: Vec<Raw> = sample.texels(Image::raw_over_texel);
        let truth = move |position, covariance| sample.image.read_four(&texels, position, covariance)[..1].to_vec();
        return Ok(("four_moments_read", vec![image.table("moments", four)?], Box::new(truth)));
    }
    let image = MomentMipmap::new(side, side, &sample.values, Edge::Repeat)?;
    let texels = sample.texels(Image::over_texel);
    let truth = move |position, covariance| sample.image.read(&texels, position, covariance)[..1].to_vec();
    let two = if halves { Format::Rg16Float } else { Format::Rg32Float };
    Ok(("moments_read", vec![image.table("moments", two)?], Box::new(truth)))
}

/// Whether moments are those of values from 0 to 1.
fn sound(source: Source, found: &[f64], slack: f64) -> bool {
    let value = |mean: f64| (-slack..=1.0 + slack).contains(&mean);
    match (source, found) {
        (Source::SlopeMoments, &[x, y, xx, xy, yy]) => {
            let most = 0.0..=0.25 + slack;
            value(x) && value(y) && most.contains(&xx) && most.contains(&yy) && xy * xy <= xx * yy
        }
        (Source::FourMoments, &[mean, variance, third, fourth]) => {
            let some = (0.0..=0.25 + slack).contains(&variance) && third.abs() <= 0.25 + slack;
            value(mean) && some && (0.0..=0.25 + slack).contains(&fourth)
        }
        (_, &[mean, deviation]) => value(mean) && (0.0..=0.5 + slack).contains(&deviation),
        _ => false,
    }
}

/// Reads a pyramid over so many footprints: means are judged, of slopes covariances, too.
///
/// # Errors
/// A message where an image cannot be made, or the device refuses it.
pub fn read(device: &Device, source: Source, case: Case, count: usize) -> Result<Outcome, String> {
    let (name, tables, truth) = reader(source, case).map_err(|error| error.to_string())?;
    let textures = tables.iter().map(|table| device.upload(table, Address::Repeat));
    let textures = textures.collect::<Result<Vec<Texture>, _>>().map_err(|error| error.to_string())?;
    let scale = (side(case) * side(case)) as f64;
    let point = |footprint: &Footprint| {
        let covariance = footprint.covariance().map(|part| scale * part);
        [&footprint.position[..2], &covariance].concat().into_iter().map(|part| f64::from(part as f32)).collect()
    };
    let footprints = Footprint::all(case, Some(0.5), count);
    let points: Vec<Vec<f64>> = footprints.iter().map(point).collect();
    let found = Function::of_shelf(name)?.results(device, &textures.iter().collect::<Vec<_>>(), &points)?;
    let contract = source.contract()?;
    let mut outcome = Outcome::new(source.name(), case);
    let slack = if case == Case::HalfTables { HALVES } else { 1e-6 };
    for ((point, footprint), found) in points.iter().zip(&footprints).zip(found) {
        outcome.count(point, sound(source, &found, slack));
        if case == Case::NoNumbers {
            continue;
        }
        let truth = truth([point[0], point[1]], [point[2], point[3], point[4]]);
        let promised = contract + source.besides(case, footprint);
        outcome.judge(point, &found, &truth, Some((&truth, promised)));
    }
    Ok(outcome)
}
