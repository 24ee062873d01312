//! Pyramids of slopes against what the length of a mean normal says: Toksvig 2005, "Mipmapping normal maps".

use prefilter::reference::moments::{Beyond, Image};
use prefilter::{Edge, SlopeMipmap};

use crate::photograph;

/// Slopes of a part of the gravel, along y stretched by a factor: the map and the images of x and y.
fn slopes(depth: f64, across: f64) -> (Vec<[f32; 2]>, [Image; 2]) {
    let (image, _) = photograph("gravel.png", Beyond::Repeat);
    let slope = |at: usize| {
        let (x, y) = ((at % 64) as f64 + 0.5, (at / 64) as f64 + 0.5);
        let along = 0.5 * depth * (image.value(x + 1.0, y) - image.value(x - 1.0, y));
        let down = 0.5 * depth * across * (image.value(x, y + 1.0) - image.value(x, y - 1.0));
        [along as f32, down as f32]
    };
    let slopes: Vec<_> = (0..64 * 64).map(slope).collect();
    let images = [0, 1].map(|axis| {
        let values = slopes.iter().map(|slope| f64::from(slope[axis])).collect();
        Image { width: 64, height: 64, values, beyond: Beyond::Repeat }
    });
    (slopes, images)
}

/// The variance that the length of the mean normal stands for, over a texel of a level, by 4² points a texel.
fn by_length([x, y]: &[Image; 2], level: usize, texel: usize) -> f64 {
    let (side, columns) = (4 << level, 64 >> level);
    let mut sum = [0.0; 3];
    for point in 0..side * side {
        let column = texel % columns * side + point % side;
        let row = texel / columns * side + point / side;
        let [u, v] = [column, row].map(|at| (at as f64 + 0.5) / 4.0);
        let (across, down) = (x.value(u, v), y.value(u, v));
        let length = (1.0 + across * across + down * down).sqrt();
        sum.iter_mut().zip([-across, -down, 1.0]).for_each(|(sum, part)| *sum += part / length);
    }
    let length = sum.iter().map(|part| part * part).sum::<f64>().sqrt() / (side * side) as f64;
    (1.0 - length) / length
}

/// The length's variance as multiples of the covariance's mean, largest and smallest one: geometric means of texels.
fn ratios(depth: f64, across: f64, level: usize) -> [f64; 3] {
    let (slopes, images) = slopes(depth, across);
    let pyramid = SlopeMipmap::from_slopes(64, 64, &slopes, Edge::Repeat).unwrap();
    let texels = pyramid.levels()[level].texels.chunks(5);
    let (mut logs, count) = ([0.0; 3], texels.len() as f64);
    for (number, texel) in texels.enumerate() {
        let [first, cross, second] = [texel[2], texel[3], texel[4]].map(f64::from);
        let (xx, xy, yy) = (first * first, first * cross, cross * cross + second * second);
        let (mean, apart) = (0.5 * (xx + yy), (0.25 * (xx - yy) * (xx - yy) + xy * xy).sqrt());
        let length = by_length(&images, level, number);
        let own = [mean, mean + apart, mean - apart];
        logs.iter_mut().zip(own).for_each(|(log, own)| *log += (length / own).ln() / count);
    }
    logs.map(f64::exp)
}

#[test]
fn the_length_of_a_mean_normal_knows_no_axes() {
    for (depth, across) in [(0.5, 1.0), (5.0, 1.0), (0.5, 0.25), (5.0, 0.25)] {
        for level in [3, 5] {
            let [mean, largest, smallest] = ratios(depth, across, level);
            println!("depth {depth}, across {across}, level {level}: {mean:.3} {largest:.3} {smallest:.3}");
            // The figures of the documentation: what shallow normals say of the mean, and steep ones less.
            let wanted = if depth < 1.0 { 0.98..1.0 } else { 0.75..0.85 };
            assert!(wanted.contains(&mean), "{depth} {across} {level}: {mean}");
            let stretched = (0.4..0.55).contains(&largest) && (7.0..11.5).contains(&smallest);
            assert!(across == 1.0 || stretched, "{depth} {level}: {largest} {smallest}");
        }
    }
}
