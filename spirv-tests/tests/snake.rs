//! Question 3 for combinations of color by values and by slopes: is the model good? A snake near and far against rays
//! to all of its scales.

use prefilter::gpu::Device;
use spirv_tests::imaging::look::Quantity;
use spirv_tests::snake::judge::{judge, Extent, Judged, Row};
use spirv_tests::snake::method::Method;
use spirv_tests::snake::{table, Error};

const EXTENT: Extent = Extent { size: [96, 66], strata: [8, 16, 32], seeds: 1 };

/// Whether the truth is known three times better than every figure.
fn truth_is_sharp(judged: &Judged) {
    for row in &judged.rows {
        for (quantity, method) in Quantity::ALL.into_iter().flat_map(|of| Method::ALL.map(|method| (of, method))) {
            let (figure, error) = (row.rms(method, quantity).value, row.truth_error(quantity));
            let (view, name) = (row.view.name, quantity.name());
            assert!(3.0 * error < figure, "{view}, {name}, {}: {figure} against {error}", method.label());
        }
    }
}

/// Every step of filtering brings the color nearer to the truth, by a factor.
fn each_is_nearer(row: &Row, factor: f64) {
    for quantity in Quantity::ALL {
        let [naive, all, ours] = [Method::Naive, Method::All, Method::Ours].map(|of| row.rms(of, quantity).value);
        let what = format!("{}, {}: {naive}, {all} and {ours}", row.view.name, quantity.name());
        assert!(factor * all < naive && factor * ours < all, "{what}");
    }
}

#[test]
fn a_snake_near_and_far() -> Result<(), Error> {
    let judged = judge(&Device::new()?, EXTENT, &|_| ())?;
    println!("{}", table::text(&judged));
    truth_is_sharp(&judged);
    let [near, whole, far] = &judged.rows[..] else { panic!("{} views", judged.rows.len()) };
    each_is_nearer(near, 1.0);
    each_is_nearer(whole, 1.3);
    each_is_nearer(far, 2.0);
    Ok(())
}
