//! Color maps: what the constructors make, and what they refuse.

use prefilter::transfer::color_map::{Knot, MAX_KNOTS};
use prefilter::{ColorMap, Error};

type Outcome = Result<(), Box<dyn std::error::Error>>;

const BLACK: [f32; 3] = [0.0; 3];
const WHITE: [f32; 3] = [1.0; 3];

fn value(map: &ColorMap, at: f64) -> [f64; 3] {
    let [red, green, blue, _] = map.reference().value(at);
    [red, green, blue]
}

#[test]
fn a_position_given_twice_is_a_hard_edge() -> Outcome {
    let map = ColorMap::gradient([(0.0, BLACK), (0.5, [0.25, 0.5, 0.75]), (0.5, WHITE), (1.0, BLACK)])?;
    assert_eq!(map.knots().len(), 3);
    let edge = Knot { position: 0.5, left: [0.25, 0.5, 0.75, 0.0], right: [1.0, 1.0, 1.0, 0.0] };
    assert_eq!(map.knots()[1], edge);
    assert_eq!(value(&map, -9.0), [0.0; 3]);
    assert_eq!(value(&map, 0.25), [0.125, 0.25, 0.375]);
    assert_eq!(value(&map, 0.5), [1.0; 3]);
    assert_eq!(value(&map, 0.75), [0.5; 3]);
    Ok(())
}

#[test]
fn bands_hold_their_colors_between_edges() -> Outcome {
    let map = ColorMap::bands(BLACK, [(0.25, [0.5; 3]), (0.75, WHITE)])?;
    for (at, gray) in [(0.0, 0.0), (0.24, 0.0), (0.26, 0.5), (0.74, 0.5), (0.76, 1.0), (7.0, 1.0)] {
        assert_eq!(value(&map, at), [gray; 3]);
    }
    Ok(())
}

#[test]
fn texels_lie_on_the_centers_of_their_cells() -> Outcome {
    let map = ColorMap::sampled(-1.0, 3.0, &[[0.0; 4], [1.0; 4], [0.5; 4], [0.25; 4]])?;
    let positions: Vec<f32> = map.knots().iter().map(|knot| knot.position).collect();
    assert_eq!(positions, [-0.5, 0.5, 1.5, 2.5]);
    assert_eq!((map.channels(), value(&map, 0.0)), (4, [0.5; 3]));
    Ok(())
}

/// IEC 61966-2-1:1999: 0.5 encoded is 0.214041 linear, and the fourth channel is none of its business.
#[test]
fn srgb_constructors_decode_three_channels() -> Outcome {
    let near = |color: [f32; 4], linear: f32| (0..3).all(|channel| (color[channel] - linear).abs() < 1e-6);
    let half = [0.5, 0.5, 0.5, 0.5];
    let maps = [
        ColorMap::gradient_srgb([(0.0, half)])?,
        ColorMap::bands_srgb(half, [(0.0, half)])?,
        ColorMap::sampled_srgb(0.0, 1.0, &[half])?,
    ];
    for map in maps {
        let knot = map.knots()[0];
        assert!(near(knot.left, 0.214_041_14) && near(knot.right, 0.214_041_14), "{knot:?}");
        assert_eq!((knot.left[3], knot.right[3]), (0.5, 0.5));
    }
    for encoded in [0.0, 0.02, 0.04045, 0.05, 0.5, 1.0, 1.5, -0.3] {
        let back = prefilter::transfer::srgb::from_linear(prefilter::transfer::srgb::to_linear(encoded));
        assert!((back - encoded).abs() < 1e-6, "{encoded} comes back as {back}");
    }
    Ok(())
}

#[test]
fn a_row_of_an_image_is_a_map() -> Outcome {
    let mut image = image::RgbaImage::new(4, 3);
    image.put_pixel(2, 1, image::Rgba([255, 0, 255, 51]));
    let map = ColorMap::image_row(&image.clone().into(), 1, 0.0, 1.0)?;
    assert_eq!((map.channels(), map.knots().len()), (4, 4));
    assert_eq!(map.knots()[2].left, [0.2, 0.0, 0.2, 0.2]); // premultiplied
    let opaque = image::DynamicImage::ImageRgba8(image).to_rgb8();
    assert_eq!(ColorMap::image_row(&opaque.clone().into(), 1, 0.0, 1.0)?.channels(), 3);
    assert!(matches!(ColorMap::image_row(&opaque.into(), 3, 0.0, 1.0), Err(Error::Size { count: 3, .. })));
    Ok(())
}

#[test]
fn a_colorgrad_gradient_is_a_map() -> Outcome {
    let gradient = colorgrad::preset::viridis();
    let map = ColorMap::colorgrad(&gradient, 33)?;
    assert_eq!((map.channels(), map.knots().len()), (3, 33));
    let [red, green, blue, _] = colorgrad::Gradient::at(&gradient, 0.5).to_linear_rgba();
    assert_eq!(map.knots()[16].left[..3], [red, green, blue]);
    assert!(matches!(ColorMap::colorgrad(&gradient, 1), Err(Error::Size { count: 1, .. })));
    assert!(matches!(ColorMap::colorgrad(&gradient, MAX_KNOTS + 1), Err(Error::Size { .. })));
    Ok(())
}

#[test]
fn maps_that_are_none_are_refused() {
    let none: [(f32, [f32; 3]); 0] = [];
    assert!(matches!(ColorMap::gradient(none), Err(Error::Size { count: 0, .. })));
    assert!(matches!(ColorMap::bands(BLACK, none), Err(Error::Size { count: 0, .. })));
    assert!(matches!(ColorMap::sampled::<3>(0.0, 1.0, &[]), Err(Error::Size { count: 0, .. })));
    assert!(matches!(ColorMap::gradient([(0.0, [0.0; 2])]), Err(Error::Size { count: 2, .. })));
    assert!(matches!(ColorMap::gradient([(0.0, [0.0; 5])]), Err(Error::Size { count: 5, .. })));
    let many = (0..=MAX_KNOTS).map(|index| (index as f32, BLACK));
    assert!(matches!(ColorMap::gradient(many), Err(Error::Size { .. })));
    assert!(matches!(ColorMap::sampled(1.0, 1.0, &[BLACK]), Err(Error::Value { .. })));
    assert!(matches!(ColorMap::sampled(0.0, f32::NAN, &[BLACK]), Err(Error::Value { .. })));
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e6] {
        assert!(matches!(ColorMap::gradient([(bad, BLACK)]), Err(Error::Value { .. })), "position {bad}");
        assert!(matches!(ColorMap::gradient([(0.0, [0.0, bad, 0.0])]), Err(Error::Value { .. })), "color {bad}");
        assert!(matches!(ColorMap::bands([bad; 3], [(0.0, BLACK)]), Err(Error::Value { .. })), "band {bad}");
    }
    let unsorted = ColorMap::gradient([(0.5, BLACK), (0.25, WHITE)]);
    let message = unsorted.map(|_| ()).unwrap_err().to_string();
    assert_eq!(message, "stop 1's position is 0.25; allowed is not below the position before it, 0.5");
    // The place is that in the input, where a hard edge counts twice.
    let late = ColorMap::gradient([(0.5, BLACK), (0.5, WHITE), (0.7, [0.0, f32::NAN, 0.0])]);
    let message = late.map(|_| ()).unwrap_err().to_string();
    assert_eq!(message, "a color channel of stop 2 is NaN; allowed is a number from -65504 to 65504");
    let tripled = ColorMap::gradient([(0.5, BLACK), (0.5, WHITE), (0.5, BLACK)]);
    assert!(matches!(tripled, Err(Error::Value { .. })));
    assert!(matches!(ColorMap::bands(BLACK, [(0.5, WHITE), (0.5, BLACK)]), Err(Error::Value { .. })));
}

#[test]
fn a_map_survives_serialization_and_a_broken_one_does_not() -> Outcome {
    let map = ColorMap::gradient([(0.0, [0.1, 0.2, 0.3, 0.4]), (0.7, [0.9, 0.8, 0.7, 0.6])])?;
    let text = serde_json::to_string(&map)?;
    assert_eq!(serde_json::from_str::<ColorMap>(&text)?, map);
    let broken = text.replace("0.7,\"left\"", "-0.7,\"left\"");
    assert_ne!(broken, text);
    assert!(serde_json::from_str::<ColorMap>(&broken).is_err_and(|error| error.to_string().contains("above")));
    let three = text.replace("\"channels\":4", "\"channels\":3");
    assert_ne!(three, text);
    assert!(serde_json::from_str::<ColorMap>(&three).is_err_and(|error| error.to_string().contains("fourth")));
    Ok(())
}
