//! Surfaces whose slopes lie on a line, but for rounding: views along the ridges are where factors lose their digits.

use std::f64::consts::TAU;

use prefilter::reference::slopes::Visible;

use crate::device::{run, worse};
use crate::{direction, single, Random};

const CHAIN: &str = "
struct chain { mean: vec2f, covariance: vec3f, factor: vec4f }
fn asked(view: vec3f, covariance: vec3f, mean_slope: vec2f) -> chain {
    let factor = slopes_factor(view, covariance);
    let moments = slopes_moments(slopes_parameter(view, mean_slope, factor));
    let mean = mean_slope + moments.x * factor.xy;
    return chain(mean, slopes_covariance(factor, moments.y), factor);
}";

/// The largest errors of the visible mean, of the visible covariance and of the sum of the factor's outer products, in
/// deviations of all slopes, for surfaces with the correlation 1 − rest, half of them seen along the ridges but for
/// 1e-9 to 1 radians. What is seen from below the horizon does not count.
fn errors(rest: f64) -> Result<[f64; 3], String> {
    let mut random = Random::new(31);
    let mut views = Vec::new();
    while views.len() < 40_000 {
        let [x, y] = [random.between(0.05, 1.0), random.between(0.05, 1.0)];
        let sign = random.pick([-1.0, 1.0]);
        let (near, anywhere) = (random.pick([-1.0, 1.0]) * random.between(1e-9, 1.0), TAU * random.unit());
        let azimuth = random.pick([x.atan2(-sign * y) + near, anywhere]);
        let height = random.unit();
        let view = direction(random.pick([height, 0.1 * height]), azimuth);
        let [sx, sy] = [0.2 * random.unit(), 0.2 * random.unit()];
        let visible =
            Visible { view, covariance: single([x * x, sign * (1.0 - rest) * x * y, y * y]), mean: single([sx, sy]) };
        // A stored covariance may be none.
        let [xx, xy, yy] = visible.covariance;
        if visible.parameter() > 0.0 && xx * yy > xy * xy {
            views.push(visible);
        }
    }
    let point = |visible: &Visible| [&visible.view[..], &visible.covariance, &visible.mean].concat();
    let points: Vec<Vec<f64>> = views.iter().map(point).collect();
    let mut most = [0.0; 3];
    for (visible, got) in views.iter().zip(run(CHAIN, &points)?) {
        let (mean, covariance) = visible.moments();
        let trace = visible.covariance[0] + visible.covariance[2];
        let [ex, ey, fx, fy] = [got[5], got[6], got[7], got[8]];
        let sum = [ex * ex + fx * fx, ex * ey + fx * fy, ey * ey + fy * fy];
        for i in 0..3 {
            most[1] = worse(most[1], (got[2 + i] - covariance[i]).abs() / trace);
            most[2] = worse(most[2], (sum[i] - visible.covariance[i]).abs() / trace);
            most[0] = if i < 2 { worse(most[0], (got[i] - mean[i]).abs() / trace.sqrt()) } else { most[0] };
        }
    }
    let [mean, covariance, whole] = most;
    println!("1 - correlation {rest:e}: mean {mean:.1e}, covariance {covariance:.1e}, all slopes {whole:.1e}");
    Ok(most)
}

#[test]
fn ridges_keep_their_moments() -> Result<(), String> {
    for (rest, mean) in [(1e-2, 1e-5), (1e-4, 1e-3), (1e-6, 1e-2), (1e-7, 0.1), (0.0, 0.2)] {
        let most = errors(rest)?;
        assert!(most[0] <= mean && most[1] <= mean && most[2] <= 2e-4, "{most:?}");
    }
    Ok(())
}

/// Ridges along an axis have an exact covariance; from along them nothing of their slopes is foreshortened.
#[test]
fn ridges_along_an_axis_are_exact() -> Result<(), String> {
    let mut points = Vec::new();
    for z in [0.01, 0.3, 0.9] {
        for azimuth in [0.0, 1e-9, -1e-7, 1e-5, 1e-3, 0.1, 0.4 * TAU, 0.5 * TAU] {
            points.push([&direction(z, azimuth)[..], &[0.0, 0.0, 0.25], &[0.0; 2]].concat());
        }
    }
    for (point, got) in points.iter().zip(run(CHAIN, &points)?) {
        let &[x, y, z, ..] = &point[..] else { return Err("a point is short".into()) };
        let (mean, [xx, xy, yy]) = Visible { view: [x, y, z], covariance: [0.0, 0.0, 0.25], mean: [0.0; 2] }.moments();
        for (got, truth) in got.iter().zip([mean[0], mean[1], xx, xy, yy]) {
            assert!((got - truth).abs() <= 1e-6, "{point:?}: {got} {truth}");
        }
    }
    Ok(())
}

/// The factors as the notes have them: along ridges no slope is along the view, the determinant is 0, and all are lost.
#[test]
fn a_determinant_alone_loses_ridges() -> Result<(), String> {
    let notes = "
fn asked(view: vec3f, covariance: vec3f) -> vec3f {
    let h = view.xy * inverseSqrt(dot(view.xy, view.xy));
    let p = vec2f(covariance.x * h.x + covariance.y * h.y, covariance.y * h.x + covariance.z * h.y);
    let inverse = inverseSqrt(max(dot(h, p), 1e-20));
    let g = sqrt(max(covariance.x * covariance.z - covariance.y * covariance.y, 0.0)) * inverse;
    return slopes_covariance(vec4f(-p * inverse, vec2f(-h.y, h.x) * g), 1.0);
}";
    let ours = "
fn asked(view: vec3f, covariance: vec3f) -> vec3f {
    return slopes_covariance(slopes_factor(view, covariance), 1.0);
}";
    let points = [[&direction(0.3, 0.0)[..], &[0.0, 0.0, 0.25]].concat()];
    assert_eq!(run(notes, &points)?, [[0.0; 3]]);
    assert_eq!(run(ours, &points)?, [[0.0, 0.0, 0.25]]);
    Ok(())
}
