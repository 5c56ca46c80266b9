//! The value of a symbol.

use crate::Vec3;

/// The value of a symbol.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A number.
    Number(f32),
    /// A point, a direction or a colour.
    Vector(Vec3),
    /// A word.
    Word(&'static str),
}

impl From<f32> for Value {
    fn from(number: f32) -> Self {
        Self::Number(number)
    }
}

impl From<Vec3> for Value {
    fn from(vector: Vec3) -> Self {
        Self::Vector(vector)
    }
}

impl TryFrom<Value> for f32 {
    type Error = Value;

    fn try_from(value: Value) -> Result<Self, Value> {
        if let Value::Number(number) = value { Ok(number) } else { Err(value) }
    }
}

impl TryFrom<Value> for Vec3 {
    type Error = Value;

    fn try_from(value: Value) -> Result<Self, Value> {
        if let Value::Vector(vector) = value { Ok(vector) } else { Err(value) }
    }
}
