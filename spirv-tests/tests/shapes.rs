//! Question 3: what values over footprints of images are taken for, with their moments known exactly. Learned tables
//! are learned on the left half of an image and judged on the right one, each mirrored beyond its edges.

use std::error::Error;

use prefilter::gpu::Device;
use prefilter::reference::moments::{Beyond, Image};
use prefilter::{ColorMap, Distribution, Kernel, Learned, Module, Scene, Tier};
use spirv_tests::exports::ExportKernel;
use spirv_tests::maps::named;
use spirv_tests::random::Random;

type Outcome = Result<(), Box<dyn Error + Send + Sync>>;

/// Deviations of footprints in texels, round ones.
const SIZES: [f64; 3] = [2.0, 8.0, 32.0];

/// Footprints of each size: a figure's standard error is below a twentieth of it.
const COUNT: usize = 400;

/// Both halves of an image of the examples, stretched to [0, 1] together: to learn from and to judge.
fn halves(name: &str) -> Result<(Learned, Image), Box<dyn Error + Send + Sync>> {
    let path = format!("{}/../examples/data/{name}", env!("CARGO_MANIFEST_DIR"));
    let gray = image::open(path)?.into_luma16();
    let (width, height) = (gray.width() as usize, gray.height() as usize);
    let raw: Vec<f32> = gray.into_raw().into_iter().map(f32::from).collect();
    let (low, high) = raw.iter().fold((f32::MAX, f32::MIN), |(low, high), &value| (low.min(value), high.max(value)));
    let half = width / 2;
    let part = |from: usize| -> Vec<f32> {
        let rows = raw.chunks(width).flat_map(|row| &row[from..from + half]);
        rows.map(|value| (value - low) / (high - low)).collect()
    };
    let judged = part(width - half).into_iter().map(f64::from).collect();
    let learned = Learned::from_image(half as u32, height as u32, &part(0))?;
    Ok((learned, Image { width: half, height, values: judged, beyond: Beyond::Mirror }))
}

/// Mean, deviation, skewness and excess kurtosis over footprints of one size, and the mean colors of both maps.
fn footprints(image: &Image, maps: [&ColorMap; 2], size: f64) -> Vec<([f32; 4], [[f64; 3]; 2])> {
    let maps = maps.map(ColorMap::reference);
    let mut random = Random::new(size as u32);
    let footprint = |_| {
        let position = [image.width, image.height].map(|side| side as f64 * random.unit());
        let variance = size * size;
        let sums = image.mean(position, [variance, 0.0, variance], 56, |value| {
            let (from, [one, other]) = (value - 0.5, [0, 1].map(|map: usize| maps[map].value(value)));
            let [a, b] = [from, from * from];
            [a, b, a * b, b * b, one[0], one[1], one[2], other[0], other[1], other[2]]
        });
        let [m, second, third, fourth] = [sums[0], sums[1], sums[2], sums[3]];
        let variance = (second - m * m).max(1e-12);
        let skewness = (third - 3.0 * m * second + 2.0 * m.powi(3)) / variance.powf(1.5);
        let kurtosis =
            (fourth - 4.0 * m * third + 6.0 * m * m * second - 3.0 * m.powi(4)) / (variance * variance) - 3.0;
        let moments = [0.5 + m, variance.sqrt(), skewness, kurtosis].map(|moment| moment as f32);
        (moments, [[sums[4], sums[5], sums[6]], [sums[7], sums[8], sums[9]]])
    };
    (0..COUNT).map(footprint).collect()
}

/// The colors of a module's last export, the filter, for mean and deviation and what else it takes.
fn colors(
    device: &Device,
    module: &Module,
    moments: &[[f32; 4]],
) -> Result<Vec<[f32; 4]>, Box<dyn Error + Send + Sync>> {
    let export = module.exports().last().ok_or("no export")?;
    let taken = if export.name.ends_with("pair") { 4 } else { 2 };
    let points: Vec<f32> = moments.iter().flat_map(|moments| &moments[..taken]).copied().collect();
    Ok(ExportKernel::new(device, module, export)?.run(&points)?)
}

/// Root mean square errors in thousandths, of the worst channel, for each size and distribution.
fn errors(device: &Device, image: &str) -> Result<[[[f64; 4]; 3]; 2], Box<dyn Error + Send + Sync>> {
    let (learned, judged) = halves(image)?;
    let maps = [named("terrain")?, named("steps6")?];
    let bounded = Distribution::Beta { low: 0.0, high: 1.0 };
    let mut errors = [[[0.0; 4]; 3]; 2];
    for (size, line) in SIZES.into_iter().zip(0..) {
        let known = footprints(&judged, [&maps[0], &maps[1]], size);
        let moments: Vec<[f32; 4]> = known.iter().map(|(moments, _)| *moments).collect();
        for (map, errors) in maps.iter().zip(&mut errors) {
            let scene = || Scene::new("judged").texture(map.clone());
            let exact = Tier::ClosedForm(Kernel::Exact);
            let scenes = [
                scene().tier(exact),
                scene().distribution(bounded.clone()),
                scene().tier(exact).distribution(Distribution::Pair),
                scene().distribution(Distribution::Learned(learned.clone())),
            ];
            for (scene, error) in scenes.into_iter().zip(&mut errors[line]) {
                let found = colors(device, &scene.module()?, &moments)?;
                let of = usize::from(*map == maps[1]);
                let squares = found.iter().zip(&known).map(|(found, (_, truth))| {
                    let apart = (0..3).map(|channel| (f64::from(found[channel]) - truth[of][channel]).abs());
                    apart.fold(0.0, f64::max).powi(2)
                });
                *error = 1e3 * (squares.sum::<f64>() / COUNT as f64).sqrt();
            }
        }
    }
    Ok(errors)
}

/// The table of `Distribution`'s documentation, in thousandths: for a line that begins so, for each size normal, Beta,
/// two normal and learned.
fn documented(line: &str) -> Option<[[f64; 4]; 3]> {
    let text = include_str!("../../src/filter/distribution.rs");
    let row = text.lines().find_map(|row| row.strip_prefix(&format!("/// | {line} | ")))?;
    let mut cells = row.trim_end_matches(" |").split(" | ").map(|cell| {
        let mut numbers = cell.split(", ").map(|number| number.parse().unwrap_or(f64::NAN));
        std::array::from_fn(|_| numbers.next().unwrap_or(f64::NAN))
    });
    Some([cells.next()?, cells.next()?, cells.next()?])
}

#[test]
fn distributions_of_images_keep_their_figures() -> Outcome {
    let device = Device::new()?;
    let mut far = Vec::new();
    for (image, file) in [("gravel", "gravel.png"), ("brick", "brick.png"), ("elevations", "jacksboro_dem.png")] {
        for (map, found) in ["terrain", "steps6"].iter().zip(errors(&device, file)?) {
            let figures = documented(&format!("{image}, {map}")).ok_or("no such line in the documentation")?;
            for (size, (found, figures)) in SIZES.iter().zip(found.iter().zip(figures)) {
                println!("{image}, {map}, {size} texels: normal, Beta, two, learned {found:.1?}");
                if found.iter().zip(figures).any(|(found, figure)| !((found - figure).abs() <= 1.0)) {
                    far.push(format!("{image}, {map}, {size}: {found:?} {figures:?}"));
                }
            }
        }
    }
    assert!(far.is_empty(), "{}", far.join("\n"));
    Ok(())
}
