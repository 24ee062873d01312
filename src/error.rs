//! What can go wrong, said so that it can be mended: what, where, and what is allowed.

/// Why a scene, a map, a table, a module or a device was refused. Nothing given is lost or changed by an error.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A name that cannot stand in a shader.
    #[error(
        "the name `{name}` {reason}; allowed are ASCII letters, digits and single underscores, \
         a letter first and no digit last"
    )]
    Name {
        /// The name as given.
        name: String,
        /// What is wrong with it.
        reason: String,
    },
    /// A number outside its range, NaN and infinity included.
    #[error("{what} is {value:?}; allowed is {allowed}")]
    Value {
        /// Which number, with its place in the input.
        what: String,
        /// The number as given.
        value: f32,
        /// The allowed range or relation.
        allowed: String,
    },
    /// A count or size outside its limits.
    #[error("{what} is {count}; allowed is {allowed}")]
    Size {
        /// What was counted.
        what: String,
        /// The count as given.
        count: usize,
        /// The allowed counts.
        allowed: String,
    },
    /// No tier keeps the accuracy asked for.
    #[error(
        "no tier of `{scene}` keeps an error of {asked}: the closest, {closest}, promises {bound}; \
         allow tables, narrow the ranges or ask for less"
    )]
    Accuracy {
        /// The scene's name.
        scene: String,
        /// The largest error asked for, in color units.
        asked: f32,
        /// The tier with the smallest bound.
        closest: String,
        /// Its bound in color units.
        bound: f32,
    },
    /// Two parts of the description exclude each other.
    #[error("{0}")]
    Conflict(String),
    /// A text that declares a name of the shelf.
    #[error("{path}:{collision}")]
    Collision {
        /// The name of the text: a file or the scene.
        path: String,
        /// Both places.
        collision: prefilter_wgsl::Collision,
    },
    /// A text that naga does not accept.
    #[error("{message}")]
    Shader {
        /// Path, line, column and naga's excerpt.
        message: String,
    },
    /// A shading language that cannot express a shader.
    #[error("{language}: {message}")]
    Backend {
        /// The language asked for.
        language: &'static str,
        /// The writer's message.
        message: String,
    },
    /// No device, or one that refused the work.
    #[error("{message}")]
    Device {
        /// What happened, and how to get a device.
        message: String,
    },
}

impl Error {
    /// [`Error::Value`] from its parts.
    pub(crate) fn value(what: impl Into<String>, value: f32, allowed: impl Into<String>) -> Self {
        Self::Value { what: what.into(), value, allowed: allowed.into() }
    }
}
