//! The demo of a snake: a coiled body with scales as a map of heights, colored by a pattern and by the slopes of the
//! scales, near and far, judged against rays to all of them. `cargo run --release -p spirv-tests --bin snake` makes it.
//!
//! After Heitz et al. 2014, figure 15: the skin blends a green texture with a red one by a function of the slopes. Red
//! are the sides of scales that face the tail and one side of the body. Which of them are seen depends on where the
//! body goes, so that the far snake has red and green parts though every part has as much red.
//!
//! The truth shoots rays to the body displaced by every height. What filters know is the body displaced by as many
//! heights as pixels resolve, and footprints on its base surface, on which pyramids of values and of slopes are read. A
//! map's slopes are divided by how much its texels are stretched where the body bends. Slopes that are seen count by
//! their area before the view of the tap's base surface; the light is on the slopes of scales and of the body that
//! bends over the tap, whose covariances add up. Silhouettes are the truth's for every method, and no figure holds
//! them; nothing shadows the light, but in pictures, where all methods have the same shadows.
//!
//! `docs/snake.csv` is a full run.

pub mod body;
pub mod judge;
pub mod known;
pub mod mesh;
pub mod method;
pub mod scene;
pub mod sheet;
pub mod skin;
pub mod stage;
pub mod table;
pub mod truth;

pub use crate::imaging::Error;
