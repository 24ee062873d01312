//! Vectors in space.

/// A point or a direction.
pub type Vector = [f64; 3];

/// The sum.
pub fn sum(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|axis| a[axis] + b[axis])
}

/// A vector from `b` to `a`.
pub fn difference(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

/// A multiple.
pub fn scaled(a: Vector, factor: f64) -> Vector {
    a.map(|part| factor * part)
}

/// The scalar product.
pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The vector product, by the right hand.
pub fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The length.
pub fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// The same direction with length 1.
pub fn unit(a: Vector) -> Vector {
    scaled(a, 1.0 / length(a))
}

/// What is left of a vector across a unit one.
pub fn across(a: Vector, axis: Vector) -> Vector {
    difference(a, scaled(axis, dot(a, axis)))
}

/// From `a` at 0 to `b` at 1.
pub fn between(a: Vector, b: Vector, along: f64) -> Vector {
    std::array::from_fn(|axis| a[axis] + along * (b[axis] - a[axis]))
}
