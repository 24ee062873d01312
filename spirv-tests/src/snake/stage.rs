//! What pictures show besides the snake's colors, the same in all of them and in no figure: the ground, how much of the
//! sky the snake leaves to it and to itself, and eyes.

use super::body::{Body, Ring};
use super::mesh::Mesh;
use crate::imaging::camera::{Ray, View};
use crate::imaging::look::Look;
use crate::imaging::picture::Picture;
use crate::imaging::pixel::{fill, Pixel};
use crate::imaging::vector::{cross, difference, dot, length, scaled, sum, unit, Vector};
use std::f64::consts::TAU;

/// Height of the ground: where a body of radius 1 lies on it.
const GROUND: f64 = -1.03;
/// Its color, and that of an eye.
const SAND: [f64; 3] = [0.50, 0.42, 0.31];
const EYE: [f64; 3] = [0.004, 0.004, 0.004];

/// Strata an axis of a pixel, and rays to the sky of each.
const STRATA: usize = 4;
const RAYS: usize = 16;

/// How far the eyes are from the tip of the nose.
const EYES: f64 = 1.35;

/// What a pixel shows besides.
#[derive(Clone, Copy, Debug)]
pub struct Stage {
    /// The ground where it is seen, on average.
    ground: [f64; 3],
    /// The share of the sky that the snake sees.
    sky: f64,
    /// The eyes' share of the pixel, and of it what shines.
    eye: [f64; 2],
}

/// The stage of a view; `mesh` is the body with any heights.
pub fn stage(body: &Body, mesh: &Mesh, view: &View) -> Vec<Stage> {
    let nothing = Stage { ground: [f64::NAN; 3], sky: f64::NAN, eye: [f64::NAN; 2] };
    let mut picture = vec![nothing; view.width * view.height];
    let (eyes, pixel) = (eyes(body), Pixel::default());
    let work = |column: usize, row: usize| {
        let (middle, number) = (view.middle(column, row), (row * view.width + column) as u64);
        let places = pixel.samples(STRATA, 7, number);
        let rays = places.map(|[right, down]| view.ray([middle[0] + right, middle[1] + down]));
        look(mesh, &eyes, rays.collect(), number)
    };
    fill(&mut picture, view.width, &work, &|| ());
    picture
}

/// What people are shown: what is lit of the snake before its stage. `truth` knows the snake's share.
pub fn picture(looks: &[Look], truth: &[Look], stage: &[Stage], width: usize) -> Picture {
    let shown = looks.iter().zip(truth).zip(stage).map(|((look, truth), stage)| {
        let share = if look.share == 0.0 { 0.0 } else { truth.share };
        std::array::from_fn(|channel| {
            let snake = share * stage.sky * look.lit[channel];
            let eye = stage.eye[0] * EYE[channel] + stage.eye[1];
            let rest = 1.0 - stage.eye[0] - stage.eye[1];
            (rest * (snake + (1.0 - share) * stage.ground[channel]) + eye) as f32
        })
    });
    Picture { width, height: looks.len() / width.max(1), pixels: shown.collect() }
}

fn look(mesh: &Mesh, eyes: &[(Vector, f64); 2], rays: Vec<Ray>, number: u64) -> Stage {
    let (mut snake, mut ground, mut eye) = ([0.0; 2], [0.0; 2], [0.0; 2]);
    let count = rays.len() as f64;
    for (sample, ray) in rays.into_iter().enumerate() {
        let hit = mesh.hit(ray.from, ray.way);
        let seen = eyes.iter().filter_map(|&(middle, radius)| sphere(&ray, middle, radius));
        let nearest = hit.map_or(f64::INFINITY, |hit| hit.along);
        if let Some((_, normal)) = seen.filter(|(along, _)| *along < nearest).min_by(|a, b| a.0.total_cmp(&b.0)) {
            // A sun above the eye shines in it.
            let half = unit(sum(ray.back(), unit([-0.5, -0.4, 0.75])));
            eye[usize::from(dot(half, normal) > 0.965)] += 1.0 / count;
            continue;
        }
        let seed = number * (STRATA * STRATA) as u64 + sample as u64;
        let floor = (GROUND - ray.from[2]) / ray.way[2];
        match hit {
            Some(hit) => {
                let place = sum(ray.from, scaled(ray.way, hit.along));
                snake[0] += open(mesh, place, hit.normal, seed);
                snake[1] += 1.0;
            }
            None => {
                ground[0] += open(mesh, sum(ray.from, scaled(ray.way, floor)), [0.0, 0.0, 1.0], seed);
                ground[1] += 1.0;
            }
        }
    }
    let mean = |[total, count]: [f64; 2]| if count == 0.0 { 1.0 } else { total / count };
    let light = mean(ground);
    Stage { ground: SAND.map(|channel| channel * light), sky: mean(snake), eye }
}

/// The share of the sky, by its irradiance on level ground, that the snake leaves to a place. What of the hemisphere
/// about the normal is below the ground counts as half open.
fn open(mesh: &Mesh, place: Vector, normal: Vector, seed: u64) -> f64 {
    let start = sum(place, scaled(normal, 0.05));
    let least = (0..3).min_by(|&a, &b| normal[a].abs().total_cmp(&normal[b].abs())).unwrap_or(0);
    let mut axis = [0.0; 3];
    axis[least] = 1.0;
    let first = unit(cross(normal, axis));
    let second = cross(normal, first);
    let turn = seed as f64 * 0.618_033_988_749;
    let ray = |number: usize| {
        // A spiral over a disk, lifted to the hemisphere: equal parts of the irradiance.
        let part = (number as f64 + 0.5) / RAYS as f64;
        let (sine, cosine) = (TAU * (number as f64 * 0.618_033_988_749 + turn)).sin_cos();
        let flat = sum(scaled(first, part.sqrt() * cosine), scaled(second, part.sqrt() * sine));
        let way = sum(flat, scaled(normal, (1.0 - part).sqrt()));
        if mesh.hit(start, way).is_some() {
            0.12
        } else {
            1.0
        }
    };
    (0..RAYS).map(ray).sum::<f64>() / RAYS as f64
}

/// Where a ray meets a sphere, and the normal there.
fn sphere(ray: &Ray, middle: Vector, radius: f64) -> Option<(f64, Vector)> {
    let from = difference(ray.from, middle);
    let [a, b, c] = [dot(ray.way, ray.way), dot(from, ray.way), dot(from, from) - radius * radius];
    let along = (-b - (b * b - a * c).sqrt()) / a;
    (along > 0.0).then(|| (along, unit(sum(from, scaled(ray.way, along)))))
}

/// Middles and radii of the eyes: on both sides of the head.
fn eyes(body: &Body) -> [(Vector, f64); 2] {
    let from = body.rings.last().map_or([0.0; 3], |ring| ring.middle);
    let near = |ring: &Ring| length(difference(ring.middle, from)) > EYES;
    let Ring { middle, along, radius, .. } = body.rings[body.rings.iter().rposition(near).unwrap_or(0)];
    let left = unit(cross([0.0, 0.0, 1.0], along));
    let above = cross(along, left);
    [0.85, -0.85].map(|side| {
        let out = unit(sum(scaled(left, side), scaled(above, 0.5)));
        (sum(middle, scaled(out, 0.93 * radius)), 0.2 * radius)
    })
}
