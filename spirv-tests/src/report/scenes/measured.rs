//! What a demo finds of a scene, and the rows that it makes.

use super::row::Row;
use crate::gap::figure::Figure;
use crate::imaging::measure::samples_for;
use crate::imaging::tally::{sizes, Errors, Of};
use prefilter::Module;

/// A scene with all methods.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Its methods, in the order of the errors'.
    pub methods: Vec<Method>,
    /// Stratified samples of a pixel, by rising numbers, in the order of the errors' brute force.
    pub brute: Vec<Brute>,
    /// The errors of stills, block by block: standard errors are over blocks.
    pub stills: Vec<Errors>,
    /// Seconds of a stratified sample of a pixel.
    pub sample: f64,
    /// What standard errors are over and what else there is to say.
    pub over: String,
}

/// A method, but for its errors.
#[derive(Clone, Debug)]
pub struct Method {
    /// Its name.
    pub label: String,
    /// Seconds a pixel.
    pub seconds: f64,
    /// Seconds a pixel of the naive kernel that reads the same statistics of the same driver; None if there is none.
    pub naive: Option<f64>,
    /// What it weighs.
    pub weight: Weight,
    /// Shimmer on pan and on zoom, as far as there are motions.
    pub shimmer: Shimmer,
}

/// Shimmer on pan and on zoom, as far as there are motions.
pub type Shimmer = [Option<Figure>; 2];

/// Bytes and operations, as far as they are known.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Weight {
    /// Bytes of all textures that are read.
    pub bytes: Option<usize>,
    /// Operations of the heaviest function of each generated module, together.
    pub operations: Option<usize>,
}

impl Weight {
    /// Of generated modules, of which each is called, with `more` bytes in textures of the driver.
    pub fn of(modules: &[&Module], more: usize) -> Self {
        let costs = || modules.iter().map(|module| module.cost());
        Self {
            bytes: Some(more + costs().map(|cost| cost.table_bytes).sum::<usize>()),
            operations: Some(costs().map(|cost| cost.operations).sum()),
        }
    }
}

/// Stratified samples of a pixel.
#[derive(Clone, Copy, Debug)]
pub struct Brute {
    /// How many.
    pub samples: usize,
    /// Shimmer on pan and on zoom where in every frame a pixel has the same samples.
    pub shimmer: Shimmer,
}

/// Samples that brute force has rows of.
pub const SHOWN: [usize; 5] = [4, 16, 64, 256, 1024];

impl Measured {
    /// The rows of methods, and of brute force.
    pub fn rows(&self) -> (Vec<Row>, Vec<Row>) {
        let figure = |of| sizes(&self.stills, of, None);
        let brute = self.brute.iter().enumerate();
        let measured: Vec<(usize, f64)> =
            brute.map(|(number, brute)| (brute.samples, figure(Of::Brute(number)).rms.value)).collect();
        let row = |of: Of, method: &Method| {
            let sizes = figure(of);
            let samples = match of {
                // It is known, and its errors need not fall with every step.
                Of::Brute(number) => Ok(self.brute[number].samples as f64),
                _ => samples_for(sizes.rms.value, &measured),
            };
            Row {
                method: method.label.clone(),
                rms: sizes.rms,
                percentile: sizes.percentile,
                maximum: sizes.maximum,
                pan: method.shimmer[0],
                zoom: method.shimmer[1],
                milliseconds: MILLISECONDS * method.seconds,
                over_naive: method.naive.map(|naive| method.seconds / naive),
                bytes: method.weight.bytes,
                operations: method.weight.operations,
                samples,
                sample: MILLISECONDS * self.sample,
            }
        };
        let methods = self.methods.iter().enumerate().map(|(number, method)| row(Of::Method(number), method));
        let brute = self.brute.iter().enumerate().filter(|(_, brute)| SHOWN.contains(&brute.samples));
        let brute = brute.map(|(number, brute)| row(Of::Brute(number), &self.stratified(*brute)));
        (methods.collect(), brute.collect())
    }

    /// Brute force as a method.
    fn stratified(&self, Brute { samples, shimmer }: Brute) -> Method {
        Method {
            label: format!("{samples} stratified samples"),
            seconds: self.sample * samples as f64,
            naive: None,
            weight: Weight::default(),
            shimmer,
        }
    }
}

/// Milliseconds a million pixels of a second a pixel.
const MILLISECONDS: f64 = 1e9;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::imaging::region::Region;

    /// Errors of two pixels in two blocks: of a method, and of brute force with 1, 4 and 64 samples.
    fn measured() -> Measured {
        let errors = |method: f32| Errors {
            regions: vec![Region::Near; 2],
            methods: vec![vec![method; 2]],
            brute: [0.4, 0.2, 0.05].map(|error| vec![error; 2]).to_vec(),
            truth: vec![0.0; 2],
        };
        let figure = |value: f64| Some(Figure { value, error: 0.0 });
        let method = Method {
            label: "made up".into(),
            seconds: 3e-9,
            naive: Some(2e-9),
            weight: Weight { bytes: Some(64), operations: Some(7) },
            shimmer: [figure(0.25), figure(0.5)],
        };
        let brute = [1, 4, 64].map(|samples| Brute { samples, shimmer: [None; 2] });
        Measured {
            methods: vec![method],
            brute: brute.to_vec(),
            stills: vec![errors(0.1), errors(0.1)],
            sample: 1e-9,
            over: String::new(),
        }
    }

    #[test]
    fn rows_are_of_methods_and_of_brute_force() {
        let (methods, brute) = measured().rows();
        let [row] = &methods[..] else { unreachable!("{methods:?}") };
        assert!((row.rms.value - 0.1).abs() < 1e-7 && (row.maximum.value - 0.1).abs() < 1e-7, "{row:?}");
        assert!(row.pan.is_some_and(|pan| pan.value == 0.25) && row.zoom.is_some_and(|zoom| zoom.value == 0.5));
        assert!(
            (row.milliseconds - 3.0).abs() < 1e-9 && row.over_naive.is_some_and(|ratio| (ratio - 1.5).abs() < 1e-9)
        );
        // Half way between 4 and 64 samples by the logarithms of their errors.
        assert!(row.samples.is_ok_and(|samples| (samples - 16.0).abs() < 1e-4), "{row:?}");
        assert!((row.speedup().0 - 16.0 / 3.0).abs() < 1e-4 && (row.bytes, row.operations) == (Some(64), Some(7)));
        let named: Vec<&str> = brute.iter().map(|row| row.method.as_str()).collect();
        assert_eq!(named, ["4 stratified samples", "64 stratified samples"]);
        assert!((brute[1].rms.value - 0.05).abs() < 1e-7 && (brute[1].milliseconds - 64.0).abs() < 1e-9);
    }
}
