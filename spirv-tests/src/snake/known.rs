//! What filters know of a pixel: a few rays to the body with the heights that its pixels resolve, and where on the maps
//! they are. All of it is the same for every method.

use super::body::{Base, Body, AROUND};
use super::mesh::Mesh;
use super::skin::SIDE;
use crate::imaging::camera::{Ray, View};
use crate::imaging::pixel::{fill, PIXEL_DEVIATION};
use crate::imaging::taps::{places, ALL_TAPS};
use crate::imaging::vector::{difference, dot, length, scaled, sum, Vector};
use std::f64::consts::TAU;

/// What is known of a tap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Known {
    /// The place on the maps, in texture coordinates.
    pub position: [f64; 2],
    /// Its changes from a pixel to the next on the right and below.
    pub changes: [[f64; 2]; 2],
    /// How much longer along the body a texel is than around it.
    pub stretch: f64,
    /// Changes of the base surface's normal likewise.
    pub turns: [Vector; 2],
    /// A unit vector to the eye in the frame.
    pub view: Vector,
    /// The frame of the base surface.
    pub frame: [Vector; 3],
}

/// What is known of every pixel of a view: of its taps, None where they miss the body, whose mesh has the heights of a
/// level.
pub fn picture(body: &Body, mesh: &Mesh, level: usize, view: &View) -> Vec<[Option<Known>; ALL_TAPS]> {
    let mut picture = vec![[None; ALL_TAPS]; view.width * view.height];
    let work = |column: usize, row: usize| {
        places(view.middle(column, row)).map(|place| known(body, mesh, level, &view.ray(place)))
    };
    fill(&mut picture, view.width, &work, &|| ());
    picture
}

fn known(body: &Body, mesh: &Mesh, level: usize, ray: &Ray) -> Option<Known> {
    let hit = mesh.hit(ray.from, ray.way)?;
    let size = (1usize << level) as f64;
    let [row, column] = hit.place.map(|part| (part + 0.5) * size - 0.5);
    let base = body.base(row, column);
    let view = base.turned(ray.back());
    let width = TAU * base.radius / AROUND as f64;
    let texels = |moved: [f64; 2]| [moved[0] / (width * base.stretch), moved[1] / width];
    let turn = |moved: [f64; 2]| body.turn([row, column], texels(moved));
    let [x, y] = toward(view);
    let bend = dot(turn([x, y]), sum(scaled(base.frame[0], x), scaled(base.frame[1], y)));
    let resolved = dot(hit.normal, ray.back());
    let moved = ray.changes.map(|change| moved(&base, ray, scaled(change, hit.along), bend, resolved));
    Some(Known {
        position: [row, column].map(|part| (part + 0.5) / SIDE as f64),
        changes: moved.map(|moved| texels(moved).map(|part| part / SIDE as f64)),
        stretch: base.stretch,
        turns: moved.map(turn),
        view,
        frame: base.frame,
    })
}

/// The direction on the surface toward the eye, which is at `view` in the frame.
fn toward(view: Vector) -> [f64; 2] {
    [view[0], view[1]].map(|part| part / view[0].hypot(view[1]).max(1e-9))
}

/// How far along the base surface and around it a place moves that is shifted in the picture. `bend` is how much the
/// surface bends away from its normal toward the eye, `resolved` the cosine of the facet of the resolved heights.
///
/// On a plane a pixel covers the more the flatter the ray; of a surface that bends away no more than is in front of its
/// silhouette; of a facet of the resolved heights no more than that.
fn moved(base: &Base, ray: &Ray, shift: Vector, bend: f64, resolved: f64) -> [f64; 2] {
    let back = ray.back();
    let view = base.turned(back);
    let [x, y, z] = base.turned(difference(shift, scaled(back, dot(shift, back))));
    let toward = toward(view);
    let seen = view[2].max(0.0);
    let least = (seen * seen + 2.0 * bend.max(0.0) * PIXEL_DEVIATION * length(shift)).sqrt();
    let cosine = least.max(resolved).min(1.0);
    // What is across the ray in its plane with the normal grows.
    let flat = x * toward[0] + y * toward[1];
    let longer = (flat * view[2] - z * view[0].hypot(view[1])) / cosine - flat;
    [x + longer * toward[0], y + longer * toward[1]]
}

#[cfg(test)]
mod tests {
    use super::super::scene::views;
    use super::*;
    use crate::imaging::pixel::Pixel;

    /// Footprints against the places that many rays of a pixel find on a smooth body: their deviations along the view.
    #[test]
    fn footprints_are_where_rays_go() {
        let (body, pixel) = (Body::new(), Pixel::default());
        let mesh = body.mesh(&[0.0; 128 * 128], 2);
        let [_, view, _] = views([180, 120], [1; 3]);
        let (mut inside, mut grazing) = (Vec::new(), Vec::new());
        for pixel_number in 0..view.width * view.height {
            let middle = view.middle(pixel_number % view.width, pixel_number / view.width);
            let Some(known) = known(&body, &mesh, 2, &view.ray(middle)) else { continue };
            let rays = pixel.samples(16, 1, pixel_number as u64).map(|[x, y]| view.ray([middle[0] + x, middle[1] + y]));
            let found: Vec<[f64; 2]> =
                rays.filter_map(|ray| super::known(&body, &mesh, 2, &ray)).map(|tap| tap.position).collect();
            // A pixel at a silhouette sees another part of the body behind it.
            let apart = |place: &[f64; 2]| (place[0] - known.position[0]).hypot(place[1] - known.position[1]);
            if found.len() < 256 || found.iter().any(|place| apart(place) > 0.2) {
                continue;
            }
            let axis = usize::from(known.view[0].abs() < known.view[1].abs());
            let mean = found.iter().map(|place| place[axis]).sum::<f64>() / 256.0;
            let variance = found.iter().map(|place| (place[axis] - mean).powi(2)).sum::<f64>() / 256.0;
            let expected = PIXEL_DEVIATION * known.changes[0][axis].hypot(known.changes[1][axis]);
            if known.view[2] > 0.5 { &mut inside } else { &mut grazing }.push(expected / variance.sqrt());
        }
        println!("{} footprints inside, {} grazing", inside.len(), grazing.len());
        for (ratios, within) in [(&mut inside, 0.25), (&mut grazing, 0.6)] {
            ratios.sort_by(f64::total_cmp);
            let [low, middle, high] = [1, 10, 19].map(|part| ratios[part * ratios.len() / 20]);
            println!("stated over found deviations: {low:.3}, {middle:.3}, {high:.3}");
            assert!(low > 1.0 - within && high < 1.0 + within && (middle - 1.0).abs() < 0.1, "{low} {middle} {high}");
        }
    }
}
