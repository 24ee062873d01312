//! What a call costs, counted on naga's own representation.

use std::collections::BTreeMap;

use naga::valid::{FunctionInfo, ModuleInfo};
use naga::{Block, Expression, Function, MathFunction, Statement, TypeInner};

/// The cost of one call.
///
/// Operations count a component of a vector as one; exp2, log2, reciprocals and square roots count as four. Loops count
/// with the iterations that the scene gives them, branches by their longer side.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Cost {
    /// Arithmetic operations on single components.
    pub operations: usize,
    /// Texture reads, filtered or not.
    pub fetches: usize,
    /// Bytes of all tables.
    pub table_bytes: usize,
}

impl Cost {
    /// One number to compare by: a fetch weighs as much as 64 operations.
    pub fn weight(self) -> usize {
        self.operations + FETCH * self.fetches
    }

    /// What the cheapest is least of: the weight, then the bytes of tables.
    pub(crate) fn order(self) -> (usize, usize) {
        (self.weight(), self.table_bytes)
    }

    fn plus(self, other: Self) -> Self {
        Self { operations: self.operations + other.operations, fetches: self.fetches + other.fetches, ..self }
    }

    fn times(self, count: usize) -> Self {
        Self { operations: self.operations * count, fetches: self.fetches * count, ..self }
    }
}

impl std::fmt::Display for Cost {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { operations, fetches, table_bytes } = self;
        let fetch = if *fetches == 1 { "fetch" } else { "fetches" };
        write!(formatter, "{operations} operations, {fetches} {fetch}, {table_bytes} table bytes")
    }
}

/// Operations that a filtered fetch of halves is worth, by the throughputs of one streaming multiprocessor: 128
/// multiply-adds and, of four halves, 2 filtered fetches a clock.
const FETCH: usize = 64;

/// The cost of calling a function, if there is one; `trips` gives the iterations of the loops in a function, by its
/// name.
pub(crate) fn call(
    module: &naga::Module,
    info: &ModuleInfo,
    name: &str,
    trips: &BTreeMap<String, usize>,
) -> Option<Cost> {
    let counter = Counter { module, info, trips };
    let found = module.functions.iter().find(|(_, function)| function.name.as_deref() == Some(name));
    found.map(|(handle, _)| counter.function(handle))
}

struct Counter<'a> {
    module: &'a naga::Module,
    info: &'a ModuleInfo,
    trips: &'a BTreeMap<String, usize>,
}

impl Counter<'_> {
    fn function(&self, handle: naga::Handle<Function>) -> Cost {
        let function = &self.module.functions[handle];
        let trips = function.name.as_ref().and_then(|name| self.trips.get(name)).copied().unwrap_or(1);
        self.block(&function.body, function, &self.info[handle], trips)
    }

    fn block(&self, block: &Block, function: &Function, info: &FunctionInfo, trips: usize) -> Cost {
        let inner = |block: &Block| self.block(block, function, info, trips);
        let statement = |statement: &Statement| match statement {
            Statement::Emit(range) => {
                let each = range.clone().map(|handle| self.expression(&function.expressions[handle], handle, info));
                each.fold(Cost::default(), Cost::plus)
            }
            Statement::Call { function, .. } => self.function(*function),
            Statement::Block(block) => inner(block),
            Statement::If { accept, reject, .. } => longer(inner(accept), inner(reject)),
            Statement::Switch { cases, .. } => cases.iter().map(|case| inner(&case.body)).fold(Cost::default(), longer),
            Statement::Loop { body, continuing, .. } => inner(body).plus(inner(continuing)).times(trips),
            _ => Cost::default(),
        };
        block.iter().map(statement).fold(Cost::default(), Cost::plus)
    }

    fn expression(&self, expression: &Expression, handle: naga::Handle<Expression>, info: &FunctionInfo) -> Cost {
        let components = components(info[handle].ty.inner_with(&self.module.types));
        let each = match expression {
            Expression::ImageSample { .. } | Expression::ImageLoad { .. } => {
                return Cost { fetches: 1, ..Cost::default() }
            }
            Expression::Binary { op: naga::BinaryOperator::Divide, .. } => 4,
            Expression::Unary { .. }
            | Expression::Binary { .. }
            | Expression::Select { .. }
            | Expression::As { .. } => 1,
            Expression::Relational { .. } => 1,
            Expression::Math { fun, .. } => math(*fun),
            _ => 0,
        };
        Cost { operations: each * components, ..Cost::default() }
    }
}

fn longer(a: Cost, b: Cost) -> Cost {
    if a.weight() < b.weight() {
        b
    } else {
        a
    }
}

fn components(inner: &TypeInner) -> usize {
    match inner {
        TypeInner::Vector { size, .. } => *size as usize,
        TypeInner::Matrix { columns, rows, .. } => *columns as usize * *rows as usize,
        _ => 1,
    }
}

/// Operations a component of the result; functions of whole vectors are counted by what they expand to.
fn math(function: MathFunction) -> usize {
    use MathFunction as F;
    match function {
        F::Exp2 | F::Log2 | F::Sqrt | F::InverseSqrt | F::Sin | F::Cos => 4,
        F::Exp | F::Log => 5,
        F::Pow | F::Tan | F::Tanh | F::Sinh | F::Cosh => 9,
        F::Asin | F::Acos | F::Atan | F::Atan2 | F::Asinh | F::Acosh | F::Atanh => 16,
        F::Clamp | F::Mix => 2,
        F::Dot => 4,
        F::Length | F::Distance => 8,
        F::Cross => 3,
        F::Normalize => 3,
        F::SmoothStep => 9,
        _ => 1,
    }
}
