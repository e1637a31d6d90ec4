//! What a motion conserves: [`Conserved`].

/// The conserved quantities of a motion, in one order.
pub trait Conserved: Send + Sync {
    /// Returns the names of the quantities.
    fn names(&self) -> Vec<String>;

    /// Appends the values of the quantities at a momentum, which may be no numbers.
    fn append(&self, momentum: &[f64], values: &mut Vec<f64>);

    /// Returns the reason why a quantity has no finite value at a momentum.
    fn without_value(&self, momentum: &[f64]) -> String;
}

impl dyn Conserved + '_ {
    /// Returns the values of the quantities at a momentum.
    ///
    /// # Errors
    /// The reason why one of them has no finite value.
    pub fn values(&self, momentum: &[f64]) -> Result<Vec<f64>, String> {
        let mut values = Vec::new();
        self.append_finite(momentum, &mut values)?;
        Ok(values)
    }

    /// Appends the values of the quantities at a momentum.
    ///
    /// # Errors
    /// The reason why one of them has no finite value.
    pub(crate) fn append_finite(
        &self,
        momentum: &[f64],
        values: &mut Vec<f64>,
    ) -> Result<(), String> {
        let before = values.len();
        self.append(momentum, values);
        match values.iter().skip(before).all(|value| value.is_finite()) {
            true => Ok(()),
            false => Err(self.without_value(momentum)),
        }
    }
}
