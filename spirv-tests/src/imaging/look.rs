//! What pixels see of a thing that covers parts of them, and how far two of them are apart.

/// What a pixel sees of a thing before others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// Mean color.
    pub color: [f64; 3],
    /// Mean of color times irradiance over π.
    pub lit: [f64; 3],
    /// The share of the pixel that it covers; what is seen of it has no meaning where that is 0.
    pub share: f64,
}

impl Look {
    /// What nobody wrote: it shows in every figure.
    pub const UNKNOWN: Self = Self { color: [f64::NAN; 3], lit: [f64::NAN; 3], share: f64::NAN };

    /// The mean of several looks at a pixel.
    pub fn mean(looks: &[Self]) -> Self {
        let share: f64 = looks.iter().map(|look| look.share).sum();
        let mean = |of: &dyn Fn(&Self) -> [f64; 3]| {
            std::array::from_fn(|channel| match share {
                0.0 => 0.0,
                _ => looks.iter().map(|look| look.share * of(look)[channel]).sum::<f64>() / share,
            })
        };
        Self { color: mean(&|look| look.color), lit: mean(&|look| look.lit), share: share / looks.len() as f64 }
    }
}

/// What is judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The mean color of what is seen.
    Color,
    /// The mean of color times irradiance.
    Lit,
}

impl Quantity {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Color, Self::Lit];

    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Color => "color",
            Self::Lit => "lit",
        }
    }

    /// The color that is judged.
    pub fn of(self, look: &Look) -> [f64; 3] {
        match self {
            Self::Color => look.color,
            Self::Lit => look.lit,
        }
    }

    /// The error of a pixel; None where one of both sees nothing of it, so that there is no color to judge.
    pub fn error(self, shown: &Look, truth: &Look) -> Option<f32> {
        if truth.share == 0.0 || shown.share == 0.0 {
            return None;
        }
        let far = self.of(shown).into_iter().zip(self.of(truth)).map(|(one, other)| (one - other).abs());
        let worst = far.fold(0.0, |worst, next| if worst >= next || f64::is_nan(worst) { worst } else { next });
        Some((truth.share * worst) as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn looks_count_by_what_they_see() {
        let look = |color: f64, share: f64| Look { color: [color; 3], lit: [2.0 * color; 3], share };
        let mean = Look::mean(&[look(0.3, 1.0), look(0.6, 0.5), look(9.0, 0.0)]);
        assert!((mean.color[0] - 0.4).abs() < 1e-12 && (mean.lit[1] - 0.8).abs() < 1e-12);
        assert!((mean.share - 0.5).abs() < 1e-12);
        assert_eq!(Look::mean(&[look(0.3, 0.0)]).color, [0.0; 3]);
        assert!(Look::mean(&[Look::UNKNOWN, look(0.3, 1.0)]).color[0].is_nan());
    }

    #[test]
    fn errors_count_by_the_snakes_share() {
        let look = |color: f64, share: f64| Look { color: [0.1, color, 0.2], lit: [color; 3], share };
        assert_eq!(Quantity::Color.error(&look(0.75, 1.0), &look(0.5, 0.5)), Some(0.125));
        assert_eq!(Quantity::Color.error(&look(0.75, 0.0), &look(0.5, 0.5)), None);
        assert_eq!(Quantity::Lit.error(&look(0.75, 1.0), &look(0.5, 0.0)), None);
        assert!(Quantity::Lit.error(&look(f64::NAN, 1.0), &look(0.5, 1.0)).is_some_and(f32::is_nan));
        assert!(Quantity::Lit.error(&Look::UNKNOWN, &look(0.5, 1.0)).is_some_and(f32::is_nan));
    }
}
