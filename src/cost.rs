//! What a call costs, counted on naga's own representation.
//!
//! The unit is a multiply-add of single numbers. Functions count by the throughput that GPUs document, and what those
//! are made of; a fetch counts by the times of modules. Measured beside each other, by chains of four numbers on
//! llvmpipe (LLVM 15, 256 bits) and on an NVIDIA H100 (`cargo xtask report --only costs` measures them anew):
//!
//! | function | counts as | llvmpipe | H100 |
//! |---|---|---|---|
//! | exp2, log2 | 4 | 5.6, 8.4 | 6.3, 6.3 |
//! | 1/x, x/y, sqrt, inverseSqrt | 4 | 2.0, 2.0, 2.7, 4.8 | 6.3 each |
//! | sin | 4 | 11 | 6.3 |
//! | exp, log | 5 | 6.3, 9.1 | 6.3, 6.2 |
//! | pow, tanh | 9 | 15, 13 | 14, 12 |
//! | atan, atan2, asin | 16 | 11, 17, 8 | 19, 53, 18 |
//! | a filtered fetch of four halves | 160 | 69, from a volume 112 | 28, from a volume 79 |
//!
//! In modules a fetch takes longer than in a chain, as tables are read here and there and not always at one texel: the
//! fits with the least relative errors have it at 173 operations on llvmpipe and at 143 on the H100. With 160, weights
//! and times have rank correlations of 0.956 and 0.977 there; with 64, the throughputs' quotient, of 0.938 and 0.919.
//! Closed forms cost as much as tables at 7 to 10 stops on both.

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
    /// One number to compare by: a fetch weighs as much as 160 operations.
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

/// Operations that a filtered fetch of halves is worth, between what times of modules say on llvmpipe and on a GPU.
const FETCH: usize = 160;

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
///
/// Source of the fours: special functions have a quarter of the rate of multiply-adds on AMD's RDNA ("RDNA
/// Architecture", 2019) and a quarter or an eighth on NVIDIA's multiprocessors, 16 results a clock beside 64 or 128
/// ("CUDA C++ Programming Guide", throughput of native arithmetic instructions). exp and log are one multiplication
/// more; pow is log2, a product and exp2, and tanh as much; arcs are polynomials about a division.
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
