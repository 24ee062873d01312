//! From where a surface is seen: lenses, their rays, and footprints on the ground, whose mean height is 0.

/// Above everything, in any unit.
const TOP: f64 = 1e5;

/// How a picture sees the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lens {
    /// Straight down from far above. From left to right every pixel is wider than the one before by the same factor;
    /// the logarithm that does it keeps shapes. Ground that the first pixel is wide, and how much wider the last is.
    Satellite {
        /// Ground that the first pixel is wide.
        first: f64,
        /// Factor from the first to the last column.
        farther: f64,
    },
    /// A pinhole that looks level. Tangents of the elevations of the first and of the last row, and how much ground a
    /// pixel of the last row is wide.
    Pinhole {
        /// Tangents of elevation in the first and in the last row.
        tangents: [f64; 2],
        /// Ground that a pixel of the last row is wide.
        last: f64,
    },
}

/// A picture of the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// One word, for tables.
    pub name: &'static str,
    /// For people.
    pub title: &'static str,
    /// How it sees.
    pub lens: Lens,
    /// Pixels a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Where the picture has been moved to, in pixels right and down.
    pub pan: [f64; 2],
}

/// A ray, and how it changes from a pixel to the next on the right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it starts.
    pub from: [f64; 3],
    /// Where it goes, of any length.
    pub way: [f64; 3],
    /// Change of the start.
    pub from_change: [f64; 3],
    /// Change of the way.
    pub way_change: [f64; 3],
}

/// Azimuth of the pinhole's line of sight, along none of the axes by which the surface repeats.
const AHEAD: f64 = 0.4;

/// A horizontal vector of an azimuth relative to the line of sight, counted to the left.
pub fn azimuth(left: f64) -> [f64; 2] {
    let (sine, cosine) = (AHEAD + left).sin_cos();
    [cosine, sine]
}

impl View {
    /// The middle of a pixel: right of the picture's middle and down from its first row.
    pub fn middle(&self, column: usize, row: usize) -> [f64; 2] {
        [column as f64 - 0.5 * (self.width as f64 - 1.0) + self.pan[0], row as f64 + self.pan[1]]
    }

    /// The picture moved by pixels right and down, and as many times nearer.
    pub fn moved(self, pan: [f64; 2], zoom: f64) -> Self {
        let lens = match self.lens {
            Lens::Satellite { first, farther } => Lens::Satellite { first: first / zoom, farther },
            Lens::Pinhole { tangents, last } => Lens::Pinhole { tangents, last: last / zoom },
        };
        Self { lens, pan, ..self }
    }

    /// The ray of a place in the picture.
    pub fn ray(&self, place: [f64; 2]) -> Ray {
        match self.lens {
            Lens::Satellite { first, farther } => self.satellite(place, first, farther),
            Lens::Pinhole { tangents, last } => self.pinhole(place, tangents, last),
        }
    }

    fn satellite(&self, [right, down]: [f64; 2], first: f64, farther: f64) -> Ray {
        let growth = farther.ln() / (self.width as f64 - 1.0);
        let radius = first / growth * (growth * (right + 0.5 * (self.width as f64 - 1.0))).exp();
        let turn = growth * (down - 0.5 * (self.height as f64 - 1.0));
        let (sine, cosine) = turn.sin_cos();
        let from = [radius * cosine, radius * sine, TOP];
        Ray {
            from,
            way: [0.0, 0.0, -1.0],
            from_change: [growth * from[0], growth * from[1], 0.0],
            way_change: [0.0; 3],
        }
    }

    fn pinhole(&self, [right, down]: [f64; 2], tangents: [f64; 2], last: f64) -> Ray {
        // Rows below the horizon: the last has as many more than the first as their tangents say.
        let lowest = (self.height as f64 - 1.0) / (1.0 - tangents[0] / tangents[1]);
        let below = lowest - (self.height as f64 - 1.0) + down;
        let focal = lowest / tangents[1];
        let ([x, y], side) = (azimuth(0.0), azimuth(-std::f64::consts::FRAC_PI_2));
        Ray {
            from: [0.0, 0.0, last * lowest],
            way: [focal * x + right * side[0], focal * y + right * side[1], -below],
            from_change: [0.0; 3],
            way_change: [side[0], side[1], 0.0],
        }
    }
}

impl Ray {
    /// The point at a multiple of the way.
    pub fn at(&self, along: f64) -> [f64; 3] {
        std::array::from_fn(|axis| self.from[axis] + along * self.way[axis])
    }

    /// A unit vector back to the eye.
    pub fn back(&self) -> [f64; 3] {
        let length = self.way.iter().map(|part| part * part).sum::<f64>().sqrt();
        self.way.map(|part| -part / length)
    }

    /// Where the ray crosses a height.
    pub fn crossing(&self, height: f64) -> f64 {
        (height - self.from[2]) / self.way[2]
    }

    /// Ground that the pixel is wide, across the ray, at a multiple of the way.
    pub fn width(&self, along: f64) -> f64 {
        let moved = self.from_change.iter().zip(self.way_change).map(|(from, way)| from + along * way);
        moved.map(|part| part * part).sum::<f64>().sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn view(lens: Lens) -> View {
        View { name: "", title: "", lens, width: 101, height: 51, pan: [0.0; 2] }
    }

    fn pinhole(degrees: [f64; 2], last: f64) -> View {
        view(Lens::Pinhole { tangents: degrees.map(|degrees| degrees.to_radians().tan()), last })
    }

    fn satellite() -> View {
        view(Lens::Satellite { first: 0.3, farther: 100.0 })
    }

    #[test]
    fn changes_are_derivatives_of_rays() {
        for view in [satellite(), pinhole([0.5, 10.0], 0.7)] {
            let place = [7.3, 11.2];
            let (ray, step) = (view.ray(place), 1e-5);
            let moved = view.ray([place[0] + step, place[1]]);
            for axis in 0..3 {
                let from = (moved.from[axis] - ray.from[axis]) / step;
                let way = (moved.way[axis] - ray.way[axis]) / step;
                assert!((from - ray.from_change[axis]).abs() < 1e-4 * (1.0 + from.abs()), "{:?}: {from}", view.lens);
                assert!((way - ray.way_change[axis]).abs() < 1e-6, "{:?}: {way}", view.lens);
            }
        }
    }

    #[test]
    fn lenses_see_what_they_say() {
        let width = |view: &View, place: [f64; 2]| {
            let ray = view.ray(place);
            ray.width(ray.crossing(0.0))
        };
        assert!((width(&satellite(), [-50.0, 3.0]) - 0.3).abs() < 1e-9);
        assert!((width(&satellite(), [50.0, 40.0]) - 30.0).abs() < 1e-9);
        for (degrees, last) in [([12.0, 40.0], 0.45), ([0.5, 10.0], 0.7)] {
            let view = pinhole(degrees, last);
            for (row, degrees) in [(0.0, degrees[0]), (50.0, degrees[1])] {
                let [x, y, z] = view.ray([0.0, row]).back();
                assert!((z.atan2(x.hypot(y)).to_degrees() - degrees).abs() < 1e-9, "{degrees}");
            }
            assert!((width(&view, [0.0, 50.0]) - last).abs() < 1e-9, "{degrees:?}");
        }
    }
}
