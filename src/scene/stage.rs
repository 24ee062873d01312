//! The stage between the statistics of f and the filters of h = g(f): what it writes around them.

use super::candidate::{arguments, parameters};
use super::combination::Combination;
use super::layer::{listed, STATISTICS};
use super::Scene;
use crate::accuracy::Ranges;
use crate::driver::slope_moments::area;
use crate::driver::taps::vectors;
use crate::driver::Driver;
use crate::filter::height::variation;
use crate::filter::height_transfer::{averaged, Nodes, TransferTier};
use crate::module::Export;
use crate::table::Table;
use crate::Error;

/// `NAME_transferred`, mean and variance of h and of g′.
pub(super) struct Moments {
    pub text: String,
    /// What it reads.
    pub tables: Vec<Table>,
}

/// What stands between the statistics of f and those of h.
pub(super) struct Stage {
    /// The scene's name.
    pub name: String,
    pub tier: TransferTier,
    /// The means and deviations of f that occur.
    pub ranges: Ranges,
    /// `NAME_transferred`.
    pub moments: Moments,
    pub nodes: Option<Nodes>,
}

impl Stage {
    /// The tables of what stands for h.
    fn tables(&self) -> &[Table] {
        self.nodes.as_ref().map_or(&self.moments.tables, |nodes| std::slice::from_ref(&nodes.table))
    }

    /// `NAME_area`, by which taps count.
    pub fn area(&self) -> String {
        let name = &self.name;
        let body = match &self.nodes {
            None => format!(
                "    let h = {};\n    return {};\n",
                self.transferred("mean_slope"),
                area("h.slope", "h.slope_covariance")
            ),
            Some(nodes) => nodes.area(),
        };
        format!(
            "
/// Area of `{name}` in the picture for a unit of area of the mesh, hidden or not; mean, deviation and slopes are of f.
fn {name}_area(mean: f32, deviation: f32, mean_slope: vec2f, slope_covariance: vec3f, view: vec3f{}) -> f32 {{
{body}}}
",
            parameters(self.tables())
        )
    }

    /// Its value for a tap.
    pub fn area_of_tap(&self) -> String {
        let name = &self.name;
        let values = "m.moments.x, sqrt(max(m.moments.y, 0.0)), m.slope, m.slope_covariance, view";
        format!("{name}_area({values}{})", arguments(self.tables()))
    }

    /// The statistics of h, a `statistics_surface`, from those of f with an expression of its mean slope.
    fn transferred(&self, mean_slope: &str) -> String {
        format!("transfer_surface({}, {mean_slope}, slope_covariance)", self.moments_of("mean", "deviation"))
    }

    /// Mean and variance of h and of g′.
    pub fn moments_of(&self, mean: &str, deviation: &str) -> String {
        format!("{}_transferred({mean}, {deviation}{})", self.name, arguments(&self.moments.tables))
    }

    /// The name of the export around one of the heights, whose scene is called `within`.
    pub fn outer(&self, export: &Export, within: &str) -> String {
        export.name.replacen(within, &self.name, 1)
    }

    /// The export of the same name around one of the heights.
    pub fn around(&self, export: &Export, within: &str) -> String {
        let own = export.parameters();
        let needed: &[&str] = if self.nodes.is_some() {
            &["mean", "deviation", "mean_slope", "slope_covariance"]
        } else {
            &["mean", "deviation", "slope_covariance"]
        };
        let documentation = export.documentation.replace(&format!("`{within}`"), &format!("`{}`", self.name));
        let documentation: String =
            documentation.lines().map(|line| format!("/// {line}").trim_end().to_owned() + "\n").collect();
        let slope = if export.takes("mean_slope") { "mean_slope" } else { "vec2f()" };
        let call = |of: &dyn Fn(&str) -> Option<String>| {
            let list: Vec<String> = own.iter().map(|(name, _)| of(name).unwrap_or((*name).to_owned())).collect();
            format!("{}({})", export.name, list.join(", "))
        };
        let (body, tables) = match &self.nodes {
            None => {
                let body =
                    format!("    let {HEIGHTS} = {};\n    return {};\n", self.transferred(slope), call(&of_heights));
                (body, parameters(&self.moments.tables))
            }
            Some(nodes) => {
                let body = averaged(nodes, self.tier.nodes(), export.takes("view"), &call(&of_node), export.result());
                (body, parameters(std::slice::from_ref(&nodes.table)))
            }
        };
        format!(
            "{documentation}///
/// Mean, deviation and slopes are those of f, the heights h = g(f): for h stand
/// {}.
fn {}({}{tables}) -> {} {{
{body}}}
",
            self.tier,
            self.outer(export, within),
            listed(&with_statistics(&own, needed)),
            export.result(),
        )
    }

    /// `NAME_displacement`, the mean height of a driver's footprint, and what it calls.
    pub fn displacement(&self, driver: &Driver) -> String {
        let Self { name, moments, .. } = self;
        let Some(function) = driver.function(false) else { return String::new() };
        let (position, tables) = (function.dimensions.position_type(), parameters(&moments.tables));
        format!(
            "
{}
/// Mean height of `{name}` over a footprint on {}, for displacing vertices.
///
/// `dpdx` and `dpdy` are the ways from `position` to those of the neighboring vertices.
fn {name}_displacement(position: {position}, dpdx: {position}, dpdy: {position}{tables}) -> f32 {{
{}    let m = {name}_statistics(position, across, along);
    return {}.x;
}}
",
            function.statistics(name),
            function.what,
            vectors(function.pixel, position),
            self.moments_of("m.x", "sqrt(max(m.y, 0.0))")
        )
    }
}

impl Scene {
    /// The weights of a combination.
    ///
    /// # Errors
    /// A name that its exports have for something else.
    pub(super) fn weights(&self) -> Result<Vec<String>, Error> {
        let Some(Combination(expression)) = &self.combination else { return Ok(Vec::new()) };
        let weights = self.leaves(expression)?.weights;
        let taken = |weight: &&String| {
            STATISTICS.iter().any(|(name, _)| name == weight) || [HEIGHTS, "transfer"].contains(&weight.as_str())
        };
        match weights.iter().find(taken) {
            Some(weight) => {
                let what = format!("the weight `{weight}` of `{}` has a name that its module needs", self.name);
                Err(Error::Conflict(what))
            }
            None => Ok(weights),
        }
    }

    /// How much what is filtered varies with slopes: the total variation of a map, the span of one of the whole slope,
    /// and the most that light from opposite sides differs by.
    pub(super) fn varied(&self) -> f32 {
        let map = self.map().map(|map| variation(map) as f32);
        let slopes = self.slope_map.as_ref().map(|map| map.widest_span() as f32);
        let light = self.irradiance.as_ref().map(|light| {
            let polynomial = light.polynomial();
            let of = |channel: usize| polynomial[1..].iter().map(|term| term[channel].abs()).sum::<f32>();
            2.0 * (0..3).map(of).fold(0.0, f32::max)
        });
        map.or(slopes).or(light).unwrap_or(0.0)
    }
}

/// The name of the statistics of h: no parameter has it.
const HEIGHTS: &str = "surface";

/// What the heights' export takes of a normal distribution of all of them.
fn of_heights(parameter: &str) -> Option<String> {
    Some(match parameter {
        "mean" => format!("{HEIGHTS}.moments.x"),
        "deviation" => format!("sqrt({HEIGHTS}.moments.y)"),
        "mean_slope" => format!("{HEIGHTS}.slope"),
        "slope_covariance" => format!("{HEIGHTS}.slope_covariance"),
        _ => return None,
    })
}

/// What the heights' export takes of a node.
fn of_node(parameter: &str) -> Option<String> {
    Some(match parameter {
        "mean_slope" => "node_slope".to_owned(),
        "slope_covariance" => "node_covariance".to_owned(),
        _ => return None,
    })
}

/// The parameters of an export with those of the statistics of f that it does not take itself.
fn with_statistics<'a>(own: &[(&'a str, &'a str)], needed: &[&str]) -> Vec<(&'a str, &'a str)> {
    let known = |name: &str| STATISTICS.iter().any(|(statistic, _)| *statistic == name);
    let first = own.iter().position(|(name, _)| known(name)).unwrap_or(own.len());
    let (before, rest) = own.split_at(first);
    let taken = |name: &str| needed.contains(&name) || rest.iter().any(|(own, _)| *own == name);
    let statistics = STATISTICS.into_iter().filter(|(name, _)| taken(name));
    let others = rest.iter().filter(|(name, _)| !known(name));
    before.iter().copied().chain(statistics).chain(others.copied()).collect()
}
