//! Formulas as textbooks have them, each beside the function of the shelf for the same quantity.

use crate::kernel::Function;

/// The texts of the formulas.
const TEXTS: [&str; 2] = [include_str!("values.wgsl"), include_str!("surfaces.wgsl")];

/// What breaks when it is written as in a textbook.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Formula {
    /// Variance and higher moments from raw moments.
    RawMoments,
    /// The same, stored in 16 bits.
    HalfMoments,
    /// The logarithm of a probability next to 1.
    UpperTail,
    /// The logarithm of a probability next to 0.
    LowerTail,
    /// A large power of a probability.
    Power,
    /// The variance of slopes that face away.
    Slopes,
    /// What is seen below the horizon.
    Hidden,
    /// The minor axis of a long footprint.
    Axes,
    /// The direction of a footprint along an axis.
    Direction,
    /// The factor of a covariance of correlation 1.
    Factor,
    /// A ramp much narrower than the deviation.
    NarrowRamp,
    /// A ramp over values that do not vary.
    NoDeviation,
    /// A ramp over nearly one percentile.
    Shares,
    /// The cotangent of an angle.
    Angle,
    /// Smith's Λ by a rational.
    Rational,
    /// Smith's Λ by a scaled error function.
    Scaled,
    /// The angle between two azimuths.
    Azimuths,
    /// Pulses far from the origin.
    Pulses,
    /// A wave far from the origin.
    Wave,
    /// Lambert's cosine of one facet.
    Cosine,
    /// Two normal distributions that are one.
    Mixture,
}

impl Formula {
    /// All of them.
    pub const ALL: [Self; 21] = [
        Self::RawMoments,
        Self::HalfMoments,
        Self::UpperTail,
        Self::LowerTail,
        Self::Power,
        Self::Slopes,
        Self::Hidden,
        Self::Axes,
        Self::Direction,
        Self::Factor,
        Self::NarrowRamp,
        Self::NoDeviation,
        Self::Shares,
        Self::Angle,
        Self::Rational,
        Self::Scaled,
        Self::Azimuths,
        Self::Pulses,
        Self::Wave,
        Self::Cosine,
        Self::Mixture,
    ];

    /// Why the textbook's form breaks.
    pub fn why(self) -> &'static str {
        match self {
            Self::RawMoments => "E[x²] − E[x]² of values far from 0",
            Self::HalfMoments => "E[x²] − E[x]² stored in 16 bits",
            Self::UpperTail => "−log₂ Φ, where Φ rounds to 1",
            Self::LowerTail => "−log₂ (1 + erf)/2, where erf rounds to −1",
            Self::Power => "pow(Φ, 1 + Λ), where Φ rounds to 1",
            Self::Slopes => "2 − R (R + a), where slopes face away",
            Self::Hidden => "1 − Φ below the horizon, over a weight that underflows",
            Self::Axes => "eigenvalues half the trace less a root",
            Self::Direction => "the eigenvector (xy, λ − xx) along an axis",
            Self::Factor => "√(xx yy − xy²) of a correlation that rounds beyond 1",
            Self::NarrowRamp => "the difference of two kinks over a small width",
            Self::NoDeviation => "a distance over the deviation, where both are 0",
            Self::Shares => "the difference of two powers over a small span",
            Self::Angle => "tan(acos z) along the normal and at the horizon",
            Self::Rational => "a rational for Λ that is negative next to its end",
            Self::Scaled => "exp(a²) erfc(a), where exp overflows",
            Self::Azimuths => "acos of a cosine next to 1",
            Self::Pulses => "the difference of an integral far from the origin",
            Self::Wave => "the sine of a large phase",
            Self::Cosine => "√(E[c²] − E[c]²) of one facet",
            Self::Mixture => "Cardano's root, where there is no skewness",
        }
    }

    /// Whether it breaks by what WGSL permits a device's own functions, which some keep better.
    pub fn is_the_devices(self) -> bool {
        self == Self::Wave
    }

    /// The function of the shelf for the quantity.
    pub fn shelf(self) -> &'static str {
        match self {
            Self::RawMoments => "four_moments_pair",
            Self::HalfMoments => "moments_mixed",
            Self::UpperTail | Self::LowerTail => "normal_surprisal",
            Self::Power => "heights_cdf",
            Self::Slopes => "slopes_moments",
            Self::Hidden => "slopes_tail",
            Self::Axes => "footprint_deviations",
            Self::Direction => "footprint_direction",
            Self::Factor => "slopes_factor",
            Self::NarrowRamp | Self::NoDeviation => "texture_ramp",
            Self::Shares => "percentile_ramp",
            Self::Angle => "smith_parameter_round",
            Self::Rational | Self::Scaled => "smith_lambda",
            Self::Azimuths => "visibility_independence",
            Self::Pulses => "pulse_train_box",
            Self::Wave => "cosines_wave",
            Self::Cosine => "irradiance_lambert",
            Self::Mixture => "mixture_pair",
        }
    }

    /// The name of the formula in its text.
    pub fn textbook(self) -> &'static str {
        match self {
            Self::RawMoments => "textbook_moments",
            Self::HalfMoments => "textbook_halves",
            Self::UpperTail => "textbook_upper_tail",
            Self::LowerTail => "textbook_lower_tail",
            Self::Power => "textbook_power",
            Self::Slopes => "textbook_slopes",
            Self::Hidden => "textbook_hidden",
            Self::Axes => "textbook_axes",
            Self::Direction => "textbook_direction",
            Self::Factor => "textbook_factor",
            Self::NarrowRamp => "textbook_ramp",
            Self::NoDeviation => "textbook_sharp_ramp",
            Self::Shares => "textbook_shares",
            Self::Angle => "textbook_angle",
            Self::Rational => "textbook_rational",
            Self::Scaled => "textbook_scaled",
            Self::Azimuths => "textbook_azimuths",
            Self::Pulses => "textbook_pulses",
            Self::Wave => "textbook_wave",
            Self::Cosine => "textbook_cosine",
            Self::Mixture => "textbook_mixture",
        }
    }

    /// The formula as a function that runs.
    ///
    /// # Errors
    /// A message where there is no such text or naga refuses it.
    pub fn function(self) -> Result<Function, String> {
        let name = self.textbook();
        let all: Vec<_> = TEXTS.iter().flat_map(|text| prefilter_wgsl::declarations(text)).collect();
        let own = all.iter().find(|declaration| declaration.name == name);
        let own = own.ok_or_else(|| format!("there is no `{name}`"))?.text;
        // Without the other formulas: what a text does not mention is not linked.
        let called = all.iter().filter(|other| other.name != name && own.contains(&format!("{}(", other.name)));
        let behind: String = called.map(|other| format!("\n{}\n", other.text)).collect();
        Function::in_text(&format!("{own}\n{behind}"), name)
    }

    /// Where both are evaluated: numbers that f32 holds, of the function's parameters one behind the other.
    pub fn points(self) -> Vec<Vec<f64>> {
        let points = match self {
            // Means, variances, third and fourth moments of two distributions, and the share of the second.
            Self::RawMoments => vec![vec![1000.0, 0.25, 0.0, 0.1875, 1001.0, 0.25, 0.0, 0.1875, 0.25]],
            // Halves already, all of them.
            Self::HalfMoments => {
                let [means, deviations] = [[128.0, 128.5, 127.75, 128.0], [0.5, 0.75, 0.5, 0.625]];
                let cell = [&means.map(|part| part / 256.0)[..], &deviations.map(|part| part / 256.0), &[0.25, 0.5]];
                vec![cell.concat()]
            }
            Self::UpperTail => vec![vec![4.0], vec![4.7], vec![5.4]],
            Self::LowerTail => vec![vec![-4.1], vec![-6.0], vec![-13.0]],
            Self::Power => vec![vec![4.5, 1e5], vec![5.0, 1e6]],
            Self::Slopes => vec![vec![-2.5], vec![-4.0], vec![-6.0]],
            Self::Hidden => vec![vec![6.0], vec![9.0], vec![12.0]],
            Self::Axes => vec![vec![256.0, 0.0, 1e-6], vec![0.0004, 0.0, 9.0]],
            Self::Direction => vec![vec![4.0, 0.0, 1.0]],
            Self::Factor => vec![vec![0.6, 0.0, 0.8, 0.25, 0.25 + f64::from(f32::EPSILON), 0.25]],
            Self::NarrowRamp => vec![vec![0.1, 1e-5, 0.3], vec![0.02, 1e-4, 0.5]],
            Self::NoDeviation => vec![vec![0.0, 0.1, 0.0]],
            Self::Shares => vec![vec![0.01, 1e-6, 10.0], vec![1.0, 1e-5, 0.3]],
            Self::Angle => vec![vec![1.0, 0.0, 1e-4, 0.3], vec![0.01, 0.0, 0.999_95, 10.0]],
            Self::Rational => vec![vec![1.336], vec![1.58]],
            Self::Scaled => vec![vec![9.5], vec![10.0]],
            Self::Azimuths => vec![vec![0.6, 0.0, 0.8, 0.6, 6e-5, 0.8], vec![0.48, 0.36, 0.8, 0.48, 0.36, 0.8]],
            Self::Pulses => vec![vec![9999.3, 0.3, 0.01], vec![-8000.7, 0.3, 0.02]],
            Self::Wave => vec![vec![40_000.25, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.7, 0.125]],
            Self::Cosine => facets(),
            Self::Mixture => vec![vec![0.0, 0.0]],
        };
        points.into_iter().map(|point| point.into_iter().map(|number| f64::from(number as f32)).collect()).collect()
    }
}

/// Normals with their squares, and lights.
fn facets() -> Vec<Vec<f64>> {
    let facet = |index: usize| {
        let turn = 0.7 * index as f64;
        let [x, y, z] = [0.6 * turn.cos(), 0.6 * turn.sin(), 0.8];
        vec![x, y, z, x * x, x * y, y * y, x * z, y * z, z * z, 0.6, 0.0, 0.8]
    };
    (0..9).map(facet).collect()
}
