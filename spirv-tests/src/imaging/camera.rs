//! From where things in space are seen: a pinhole.

use super::vector::{cross, difference, scaled, sum, unit, Vector};

/// A picture of things in space, z being up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// One word, for tables.
    pub name: &'static str,
    /// For people.
    pub title: &'static str,
    /// Where the eye is.
    pub eye: Vector,
    /// What is in the middle of the picture.
    pub target: Vector,
    /// Pixels that an object is wide which is as wide as it is far.
    pub focal: f64,
    /// Pixels a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// How many times pictures are enlarged for people.
    pub enlarged: usize,
    /// Strata an axis of each of the two halves of the truth.
    pub strata: usize,
    /// Where the picture has been moved to, in pixels right and down.
    pub pan: [f64; 2],
}

/// A ray, and how its way changes from a pixel to the next on the right and the next below.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it starts.
    pub from: Vector,
    /// Where it goes, of any length.
    pub way: Vector,
    /// Changes of the way.
    pub changes: [Vector; 2],
}

impl View {
    /// The middle of a pixel, right of and below the picture's.
    pub fn middle(&self, column: usize, row: usize) -> [f64; 2] {
        let [right, down] = self.pan;
        [column as f64 - 0.5 * (self.width as f64 - 1.0) + right, row as f64 - 0.5 * (self.height as f64 - 1.0) + down]
    }

    /// The picture moved by pixels right and down, through a lens that is as many times longer.
    pub fn moved(self, pan: [f64; 2], zoom: f64) -> Self {
        Self { focal: self.focal * zoom, pan, ..self }
    }

    /// The ray of a place in the picture.
    pub fn ray(&self, [right, down]: [f64; 2]) -> Ray {
        let ahead = unit(difference(self.target, self.eye));
        let side = unit(cross(ahead, [0.0, 0.0, 1.0]));
        let under = cross(ahead, side);
        let way = sum(scaled(ahead, self.focal), sum(scaled(side, right), scaled(under, down)));
        Ray { from: self.eye, way, changes: [side, under] }
    }
}

impl Ray {
    /// A unit vector back to the eye.
    pub fn back(&self) -> Vector {
        scaled(unit(self.way), -1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::super::vector::{dot, length};
    use super::*;

    #[test]
    fn changes_are_derivatives_of_rays() {
        let (eye, target) = ([3.0, -20.0, 9.0], [0.3, -1.2, 0.6]);
        let view = View {
            name: "",
            title: "",
            eye,
            target,
            focal: 70.0,
            width: 60,
            height: 42,
            enlarged: 1,
            strata: 1,
            pan: [0.0; 2],
        };
        let ray = view.ray([7.3, -4.1]);
        for (place, change) in [[8.3, -4.1], [7.3, -3.1]].into_iter().zip(ray.changes) {
            let moved = difference(view.ray(place).way, ray.way);
            assert!(length(difference(moved, change)) < 1e-9, "{moved:?}");
        }
        let middle = view.ray([0.0, 0.0]);
        let target = unit(difference(view.target, view.eye));
        assert!((dot(target, middle.back()) + 1.0).abs() < 1e-12);
        // Down in the picture is down in the world.
        assert!(ray.changes[1][2] < 0.0);
    }
}
