//! Values that a filter's body finds already named: those of a view or a light, the same for every color.

/// A named value.
pub(crate) struct Shared {
    /// The name by which bodies know it.
    pub name: &'static str,
    /// Its WGSL type.
    pub kind: &'static str,
    /// The expression, of parameters and of values before it.
    pub value: String,
}

impl Shared {
    pub(super) fn new(name: &'static str, kind: &'static str, value: impl Into<String>) -> Self {
        Self { name, kind, value: value.into() }
    }
}

/// The statements that name the values.
pub(crate) fn statements(shared: &[Shared]) -> String {
    shared.iter().map(|Shared { name, value, .. }| format!("    let {name} = {value};\n")).collect()
}
