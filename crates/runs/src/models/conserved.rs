//! What a motion conserves: [`Conserved`].

/// What a motion conserves, in one order; of a motion with forces that change it, how much of it there is.
pub trait Conserved: Send + Sync {
    /// Returns the names of the quantities.
    fn names(&self) -> Vec<String>;

    /// Returns whether the motion keeps a quantity. If not, such as the energy of a motion with friction, its change is no
    /// error.
    fn is_kept(&self, _name: &str) -> bool {
        true
    }

    /// Appends the values of the quantities at a time and a momentum, which may be no numbers.
    fn append(&self, time: f64, momentum: &[f64], values: &mut Vec<f64>);

    /// Returns the reason why a quantity has no finite value at a time and a momentum.
    fn without_value(&self, time: f64, momentum: &[f64]) -> String;
}

impl dyn Conserved + '_ {
    /// Returns the values of the quantities at a time and a momentum.
    ///
    /// # Errors
    /// The reason why one of them has no finite value.
    pub fn values(&self, time: f64, momentum: &[f64]) -> Result<Vec<f64>, String> {
        let mut values = Vec::new();
        self.append_finite(time, momentum, &mut values)?;
        Ok(values)
    }

    /// Appends the values of the quantities at a time and a momentum.
    ///
    /// # Errors
    /// The reason why one of them has no finite value.
    pub(crate) fn append_finite(
        &self,
        time: f64,
        momentum: &[f64],
        values: &mut Vec<f64>,
    ) -> Result<(), String> {
        let before = values.len();
        self.append(time, momentum, values);
        match values.iter().skip(before).all(|value| value.is_finite()) {
            true => Ok(()),
            false => Err(self.without_value(time, momentum)),
        }
    }
}
