//! What a WGSL function takes and returns, as flat lists of numbers.

use naga::{ArraySize, ImageClass, ImageDimension, ScalarKind, TypeInner, VectorSize};

/// A 4-byte number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scalar {
    /// `f32`
    Float,
    /// `i32`
    Signed,
    /// `u32`
    Unsigned,
    /// `bool`, as 0 or 1.
    Bool,
}

/// The shape of a parameter or a result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A number.
    Scalar(Scalar),
    /// A vector of 2 to 4 numbers.
    Vector(usize, Scalar),
    /// A matrix of floats: columns and rows.
    Matrix(usize, usize),
    /// A structure with its members.
    Structure(String, Vec<(String, Shape)>),
    /// `texture_2d<f32>`
    Texture,
    /// `texture_3d<f32>`
    Volume,
    /// `sampler`
    Sampler,
}

/// A number within a shape.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Leaf {
    /// The expression that reads it from a value: `cell.means[2]`.
    pub path: String,
    /// What it is.
    pub scalar: Scalar,
}

/// The parameters and the result of a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signature {
    /// Names and shapes in order.
    pub parameters: Vec<(String, Shape)>,
    /// The result.
    pub result: Shape,
}

impl Signature {
    /// The signature of a function of a WGSL text.
    ///
    /// # Errors
    /// A message where naga refuses the text, the function is not there, or it takes or returns what has no shape here.
    pub fn of(text: &str, name: &str) -> Result<Self, String> {
        let module = naga::front::wgsl::parse_str(text).map_err(|error| error.emit_to_string(text))?;
        let mut functions = module.functions.iter().map(|(_, function)| function);
        let function = functions.find(|function| function.name.as_deref() == Some(name));
        let function = function.ok_or_else(|| format!("the text has no function `{name}`"))?;
        let parameters = function.arguments.iter().map(|argument| {
            let parameter = argument.name.clone().unwrap_or_default();
            let shape = shape(&module, argument.ty).map_err(|error| format!("`{name}`: `{parameter}` is {error}"))?;
            Ok((parameter, shape))
        });
        let parameters = parameters.collect::<Result<_, String>>()?;
        let result = function.result.as_ref().ok_or_else(|| format!("`{name}` returns nothing"))?;
        let result = shape(&module, result.ty).map_err(|error| format!("`{name}` returns {error}"))?;
        Ok(Self { parameters, result })
    }

    /// The numbers that the function takes, in order, flattened.
    pub fn inputs(&self) -> Vec<Leaf> {
        self.parameters.iter().flat_map(|(name, shape)| shape.leaves(name)).collect()
    }

    /// Whether the function reads textures.
    pub fn has_textures(&self) -> bool {
        self.parameters.iter().any(|(_, shape)| matches!(shape, Shape::Texture | Shape::Volume | Shape::Sampler))
    }
}

impl Shape {
    /// The numbers of a value of this shape; none for a texture or a sampler.
    pub fn leaves(&self, path: &str) -> Vec<Leaf> {
        let leaf = |path: String, scalar| Leaf { path, scalar };
        match self {
            Self::Scalar(scalar) => vec![leaf(path.to_owned(), *scalar)],
            Self::Vector(size, scalar) => (0..*size).map(|index| leaf(format!("{path}[{index}]"), *scalar)).collect(),
            Self::Matrix(columns, rows) => (0..columns * rows)
                .map(|index| leaf(format!("{path}[{}][{}]", index / rows, index % rows), Scalar::Float))
                .collect(),
            Self::Structure(_, members) => {
                members.iter().flat_map(|(name, shape)| shape.leaves(&format!("{path}.{name}"))).collect()
            }
            Self::Texture | Self::Volume | Self::Sampler => Vec::new(),
        }
    }

    /// The WGSL expression that makes a value of this shape, `number` giving the expression of each next number.
    pub fn construct(&self, number: &mut impl FnMut(Scalar) -> String) -> String {
        match self {
            Self::Scalar(scalar) => number(*scalar),
            Self::Vector(size, scalar) => {
                let numbers: Vec<String> = (0..*size).map(|_| number(*scalar)).collect();
                format!("vec{size}({})", numbers.join(", "))
            }
            Self::Matrix(columns, rows) => {
                let numbers: Vec<String> = (0..columns * rows).map(|_| number(Scalar::Float)).collect();
                format!("mat{columns}x{rows}({})", numbers.join(", "))
            }
            Self::Structure(name, members) => {
                let members: Vec<String> = members.iter().map(|(_, shape)| shape.construct(number)).collect();
                format!("{name}({})", members.join(", "))
            }
            Self::Texture | Self::Volume | Self::Sampler => String::new(),
        }
    }
}

fn scalar(scalar: naga::Scalar) -> Result<Scalar, String> {
    Ok(match (scalar.kind, scalar.width) {
        (ScalarKind::Float, 4) => Scalar::Float,
        (ScalarKind::Sint, 4) => Scalar::Signed,
        (ScalarKind::Uint, 4) => Scalar::Unsigned,
        (ScalarKind::Bool, _) => Scalar::Bool,
        other => return Err(format!("a number of the kind {other:?}")),
    })
}

fn side(size: VectorSize) -> usize {
    match size {
        VectorSize::Bi => 2,
        VectorSize::Tri => 3,
        VectorSize::Quad => 4,
    }
}

fn shape(module: &naga::Module, ty: naga::Handle<naga::Type>) -> Result<Shape, String> {
    let ty = &module.types[ty];
    Ok(match &ty.inner {
        TypeInner::Scalar(kind) => Shape::Scalar(scalar(*kind)?),
        TypeInner::Vector { size, scalar: kind } => Shape::Vector(side(*size), scalar(*kind)?),
        TypeInner::Matrix { columns, rows, .. } => Shape::Matrix(side(*columns), side(*rows)),
        TypeInner::Struct { members, .. } => {
            let members = members.iter().map(|member| {
                let name = member.name.clone().unwrap_or_default();
                shape(module, member.ty).map(|shape| (name, shape))
            });
            Shape::Structure(ty.name.clone().unwrap_or_default(), members.collect::<Result<_, _>>()?)
        }
        TypeInner::Image { dim, arrayed: false, class } => match (class, dim) {
            (ImageClass::Sampled { kind: ScalarKind::Float, multi: false }, ImageDimension::D2) => Shape::Texture,
            (ImageClass::Sampled { kind: ScalarKind::Float, multi: false }, ImageDimension::D3) => Shape::Volume,
            other => return Err(format!("a texture of the class {other:?}")),
        },
        TypeInner::Sampler { comparison: false } => Shape::Sampler,
        TypeInner::Array { size: ArraySize::Constant(size), .. } => return Err(format!("an array of {size}")),
        other => return Err(format!("of the type {other:?}")),
    })
}
