//! Combinations of layers: their colors added and multiplied, lit, and seen through masking and shadowing.
//!
//! With I = L̄ ρ̄ V̄ (κ₀ C̄₀ + κ₁ C̄h + κ₂ C̄s), every color C̄ is normalized and the visibility V̄ a factor of the
//! whole. That is section 6 of the paper, in which C̄h has V̄ in it (equation 13), but C̄₀ and C̄s have not, and the
//! reflectance ρ̄ is missing from products.
//!
//! Where color and light depend on slopes, the mean of their product is not the product of their means (Bruneton and
//! Neyret 2012, "A Survey of Nonlinear Prefiltering Methods for Efficient and Accurate Surface Shading", section 8.1).
//! What is between is estimated from five nodes of the visible slopes. Of the covariance of steps, by a component or by
//! the length of the slope, with a cosine or a light of order 2, five nodes of a normal distribution leave 0.18 (root
//! mean square), seven in a hexagon 0.15, and nine in a square or an octagon 0.15 and 0.14. A map of steepness that is
//! read from one distribution of Rice is averaged over the nodes, too: five, each of half of the variance, are closer.
//!
//! Source: Heitz, Nowrouzezahrai, Poulin and Neyret 2014, "Filtering Non-Linear Transfer Functions on Surfaces",
//! section 6.

/// `combine_nodes` of the shelf.
pub(crate) const NODES: usize = 5;

/// What ρ̄ of the full equation is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Reflectance {
    /// The caller's, passed as `reflectance`: the mean of the BRDF and the cosine of the light over what is seen.
    Given,
    /// That of a diffuse surface, Lambert's cosine over π, averaged together with the colors.
    Lambert,
}

/// 1/π.
pub(crate) const INVERSE_PI: &str = "0.31830989";

/// What `NAME_combined` says of its parameters.
pub(crate) const GIVEN_VALUES: &str = "/// A layer of values takes their mean and deviation by its name.\n";
pub(crate) const GIVEN_HEIGHTS: &str = "/// All layers of heights have one `mean` and `deviation`.\n";
pub(crate) const GIVEN_SLOPES: &str = "\
/// Slopes have a mean and a covariance, xx, xy, yy, in the tangent frame; `view` and `light` are unit vectors away from
/// the surface in that.
";
pub(crate) const GIVEN_DIRECTION: &str = "\
/// `direction` is a horizontal vector of length 1 at most, along which slopes have a component.
";

/// What the factors of `NAME_radiance` are besides the light's.
pub(crate) const GIVEN_REFLECTANCE: &str = "\
/// the color and `reflectance`, the mean over what is seen of a BRDF times the light's cosine.
";
pub(crate) const LAMBERT: &str = "\
/// the color and Lambert's cosine over pi, which are averaged together where both depend on the slopes.
";

/// Statements that name `joint`, the mean of `color` times light: of `light` and, over the nodes of the visible slopes,
/// of the colors and the light that `node` names `c` and `l` for `node_slope` and `node_covariance`. `channels` are
/// those of the color that are lit. The color's own mean is `color`, or that over the nodes.
pub(crate) fn joint(light: &str, node: &str, channels: &str, over_nodes: bool) -> String {
    let mean = if over_nodes { "color_over_all + moved" } else { "color_over_all" };
    format!(
        "    let color_over_all = color{channels};
    let light_over_all = {light};
    let node_covariance = combine_covariance(factor, moments);
    let skewness = slopes_skewness(parameter);
    var moved = vec3f();
    var turned = vec3f();
    var both = vec3f();
    var low = color_over_all;
    var high = color_over_all;
    for (var at = 0; at < combine_nodes; at++) {{
        let node = combine_node(f32(at), skewness);
        let node_slope = combine_slope(node, mean_slope, factor, moments);
{node}        let color_apart = c - color_over_all;
        let light_apart = l - light_over_all;
        moved += node.z * color_apart;
        turned += node.z * light_apart;
        both += node.z * color_apart * light_apart;
        low = min(low, c);
        high = max(high, c);
    }}
    let joint = combine_joint({mean}, light_over_all, moved, turned, both, low, high);
"
    )
}
