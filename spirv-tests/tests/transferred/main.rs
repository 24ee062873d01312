//! Scenes of transferred heights h = g(f): their exports against the model without nodes, and what they refuse.

mod identity;
mod model;
mod scenes;

type Outcome = Result<(), Box<dyn std::error::Error + Send + Sync>>;
