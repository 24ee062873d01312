//! Curvature over a pixel, on the device, against the normals of spheres and cylinders that pixels cover.

use std::f64::consts::TAU;

use prefilter::gpu::Device;
use spirv_tests::kernel::Function;
use spirv_tests::random::Random;

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    (0..3).map(|part| a[part] * b[part]).sum()
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(a: Vector) -> Vector {
    let length = dot(a, a).sqrt();
    a.map(|part| part / length)
}

/// A surface of radius 1, whose picture is taken along z: round all ways, or only across an axis in the picture.
#[derive(Clone, Copy, Debug)]
enum Shape {
    Sphere,
    Cylinder(f64),
}

impl Shape {
    /// The normal at a place of the picture.
    fn normal(self, [x, y]: [f64; 2]) -> Vector {
        match self {
            Self::Sphere => [x, y, (1.0 - x * x - y * y).sqrt()],
            Self::Cylinder(turn) => {
                let (sin, cos) = turn.sin_cos();
                let across = cos * x + sin * y;
                [across * cos, across * sin, (1.0 - across * across).sqrt()]
            }
        }
    }
}

/// A pixel of a picture: its center, its size, and the covariance of its filter in pixels².
#[derive(Clone, Copy, Debug)]
struct Pixel {
    center: [f64; 2],
    size: f64,
    filter: Vector,
}

impl Pixel {
    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.center[0] + self.size * x, self.center[1] + self.size * y]
    }

    /// The axes of a tangent frame at the center.
    fn frame(&self, shape: Shape) -> [Vector; 2] {
        let normal = shape.normal(self.center);
        let x = unit(cross([0.3, 0.8, 0.5], normal));
        [x, cross(normal, x)]
    }

    /// The covariance of the slopes in the tangent frame over the filter, in 48² points of the picture.
    fn truth(&self, shape: Shape) -> Vector {
        let (normal, frame) = (shape.normal(self.center), self.frame(shape));
        let [xx, xy, yy] = self.filter;
        let (column, rest) = (xx.sqrt(), (yy - xy * xy / xx).sqrt());
        let at = |index: usize| 4.5 * ((2 * index + 1) as f64 / 48.0 - 1.0);
        let (mut sums, mut total) = ([0.0; 5], 0.0);
        for point in 0..48 * 48 {
            let (u, v) = (at(point % 48), at(point / 48));
            let weight = (-0.5 * (u * u + v * v)).exp();
            let other = shape.normal(self.place([column * u, xy / column * u + rest * v]));
            let [x, y] = frame.map(|axis| -dot(other, axis) / dot(other, normal));
            sums.iter_mut().zip([x, y, x * x, x * y, y * y]).for_each(|(sum, part)| *sum += weight * part);
            total += weight;
        }
        let [x, y, xx, xy, yy] = sums.map(|sum| sum / total);
        [xx - x * x, xy - x * y, yy - y * y]
    }

    /// What the shelf takes, with differences to the next pixels for derivatives, as a device has them.
    fn arguments(&self, shape: Shape) -> Vec<f64> {
        let normal = shape.normal(self.center);
        let next = |offset| {
            let next = shape.normal(self.place(offset));
            [0, 1, 2].map(|part| next[part] - normal[part])
        };
        let [x, y] = self.frame(shape);
        [&next([1.0, 0.0])[..], &next([0.0, 1.0]), &x, &y, &self.filter].concat()
    }
}

/// The largest error of a covariance over its trace, and of a mesh without curvature, for pixels of a size.
fn worst(shelf: &Function, device: &Device, size: f64) -> f64 {
    let mut random = Random::new(7);
    let cases: Vec<(Shape, Pixel)> = (0..200)
        .map(|_| {
            let around = TAU * random.unit();
            let shape = random.pick([Shape::Sphere, Shape::Cylinder(around)]);
            let (radius, turn) = (0.8 * random.unit().sqrt(), TAU * random.unit());
            let [wide, tall] = [random.between(0.25, 0.6), random.between(0.25, 0.6)];
            let both = 0.7 * (2.0 * random.unit() - 1.0) * wide * tall;
            let filter = random.pick([[0.25, 0.0, 0.25], [wide * wide, both, tall * tall]]);
            (shape, Pixel { center: [radius * turn.cos(), radius * turn.sin()], size, filter })
        })
        .collect();
    let points: Vec<Vec<f64>> = cases.iter().map(|(shape, pixel)| pixel.arguments(*shape)).collect();
    let got = shelf.results(device, &[], &points).unwrap();
    assert_eq!(got.len(), cases.len());
    let of_case = cases.iter().zip(&got).map(|((shape, pixel), got)| {
        let truth = pixel.truth(*shape);
        let apart = truth.iter().zip(got).map(|(truth, got)| (truth - got).abs()).fold(0.0, f64::max);
        assert!(got.iter().all(|value| value.is_finite()) && got[0] >= 0.0 && got[2] >= 0.0, "{shape:?} {pixel:?}");
        apart / (truth[0] + truth[2])
    });
    of_case.fold(0.0, f64::max)
}

/// Errors are of first order in what a pixel turns the normal by: of the differences that stand for derivatives, whose
/// middle is not the pixel's, and of what bends over the pixel.
#[test]
fn curvature_is_that_of_spheres_and_cylinders() {
    let device = Device::new().unwrap();
    let shelf = Function::shelf().unwrap();
    let shelf = shelf.into_iter().find(|function| function.name == "curvature_covariance").unwrap();
    for (size, within) in [(0.001, 0.002), (0.01, 0.02), (0.05, 0.1)] {
        let found = worst(&shelf, &device, size);
        println!("pixels of {size} radii: {found:.4} of the trace");
        assert!(found <= within, "{size}: {found}");
    }
}
