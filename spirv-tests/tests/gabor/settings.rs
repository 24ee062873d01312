//! What a description of the noise may not say, and what its module says.

use prefilter::{Driver, Error, Gabor, GaborMethod, Pixel, Spectrum, Taps};

use crate::{module, noise, spectra, Outcome};

#[test]
fn numbers_outside_their_ranges_are_refused() {
    let good = Gabor::default();
    let hybrid = |frequency, azimuth, height| Spectrum::Hybrid { frequency, azimuth, height };
    let wrong = [
        ("bandwidth", Gabor { bandwidth: 0.0, ..good }),
        ("bandwidth", Gabor { bandwidth: f32::NAN, ..good }),
        ("kernels", Gabor { kernels: 0, ..good }),
        ("kernels", Gabor { kernels: 17, ..good }),
        ("mean", Gabor { mean: f32::INFINITY, ..good }),
        ("deviation", Gabor { deviation: -0.1, ..good }),
        ("pixel", Gabor { pixel: Pixel::Round(17.0), ..good }),
        ("frequency", Gabor { spectrum: Spectrum::Isotropic { frequency: 16.1 }, ..good }),
        ("frequency", Gabor { spectrum: Spectrum::Anisotropic { frequency: [12.0, 12.0, 0.0] }, ..good }),
        ("frequency", Gabor { spectrum: Spectrum::Anisotropic { frequency: [f32::NAN, 0.0, 0.0] }, ..good }),
        ("largest frequency", Gabor { spectrum: hybrid((2.0, 1.0), (0.0, 1.0), (0.0, 0.0)), ..good }),
        ("last azimuth", Gabor { spectrum: hybrid((1.0, 1.0), (-1.0, 5.4), (0.0, 0.0)), ..good }),
        ("largest height", Gabor { spectrum: hybrid((1.0, 1.0), (0.0, 1.0), (0.5, 1.5)), ..good }),
    ];
    for (what, gabor) in wrong {
        let error = module(gabor).err().map(|error| error.to_string()).unwrap_or_default();
        assert!(error.contains(what) && error.contains("allowed"), "{what}: `{error}`");
    }
}

#[test]
fn descriptions_survive_serialization() -> Outcome {
    for (_, spectrum) in spectra() {
        let driver = Driver::Gabor(Gabor { taps: Taps::Four, method: GaborMethod::Paper, ..noise(spectrum) });
        let text = serde_json::to_string(&driver)?;
        assert_eq!(serde_json::from_str::<Driver>(&text)?, driver);
    }
    Ok(())
}

#[test]
fn slopes_are_not_known() -> Outcome {
    let map = prefilter::ColorMap::gradient([(-0.5, [0.0; 3]), (0.5, [1.0; 3])])?;
    let scene = prefilter::Scene::new("wood").slope(map).driver(Driver::Gabor(Gabor::default()));
    assert!(matches!(scene.module(), Err(Error::Conflict(said)) if said.contains("Driver::Gabor")));
    Ok(())
}

/// The cost counts every kernel: in proportion to their number.
#[test]
fn costs_count_kernels() -> Outcome {
    let cost = |kernels| {
        Ok::<_, Box<dyn std::error::Error + Send + Sync>>(
            module(Gabor { kernels, ..Gabor::default() })?.cost().operations,
        )
    };
    let [one, two, four] = [cost(1)?, cost(2)?, cost(4)?];
    assert_eq!(four - two, 2 * (two - one));
    assert!(two - one > 64 * 50, "{one} {two}");
    Ok(())
}
