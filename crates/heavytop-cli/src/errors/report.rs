//! The report of an error for machines: what `--json` prints on stderr.

use super::error::Error;
use super::quotation::Quotation;
use serde::Serialize;

/// The report of an error, an object of JSON.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// The message, without the quoted line.
    pub error: String,
    /// The exit code of the program.
    pub exit_code: u8,
    /// The place of the wrong value in a configuration.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub place: Option<Place>,
    /// The path of what was computed until the run failed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub kept: Option<String>,
    /// The argument that resumes the run.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub resume: Option<String>,
}

/// The place of a value in a configuration.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Place {
    /// The path of the file, or the name of the option or stream.
    pub file: String,
    /// The line, from 1.
    pub line: usize,
    /// The column in characters, from 1.
    pub column: usize,
}

impl Report {
    /// Returns the report of an error of the command line, which has a text of its own.
    #[must_use]
    pub fn of_arguments(text: &str) -> Self {
        let error = text.trim().trim_start_matches("error: ").to_owned();
        Self { error, exit_code: 2, place: None, kept: None, resume: None }
    }
}

impl From<&Error> for Report {
    fn from(error: &Error) -> Self {
        let (mut place, mut kept, mut resume) = (None, None, None);
        let mut inner = error;
        loop {
            inner = match inner {
                Error::Quoted { quotation, source } => {
                    place = Some(of_quotation(quotation));
                    source
                }
                Error::Kept { partial, source } => {
                    kept = Some(partial.display().to_string());
                    source
                }
                Error::Resumable { resume: argument, source } => {
                    resume = Some(argument.clone());
                    source
                }
                Error::Interrupted { resume: argument } => {
                    resume.clone_from(argument);
                    break;
                }
                Error::Unfinished { resume: argument, .. } => {
                    resume = Some(argument.clone());
                    break;
                }
                _ => break,
            };
        }
        // Below the first line is the quoted one.
        let message = error.message();
        let error_text = match place {
            Some(_) => message.split("\n ").next().unwrap_or_default().to_owned(),
            None => message,
        };
        Self { error: error_text, exit_code: error.exit_code(), place, kept, resume }
    }
}

fn of_quotation(quotation: &Quotation) -> Place {
    let (file, line, column) = quotation.place();
    Place { file: file.into(), line, column }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn a_report_says_what_the_message_says() {
        let quotation = Box::new(Quotation::new("a.toml", "[body]\nmass = -1", 14..16, "write 1"));
        let source = Box::new(Error::AzimuthAlone);
        let report = Report::from(&Error::Quoted { quotation, source });
        let json = serde_json::to_string(&report).unwrap();
        let expected = "{\"error\":\"a.toml, line 2, column 8: [initial] azimuth needs inclination: the two give the \
                        vertical\",\"exit_code\":2,\"place\":{\"file\":\"a.toml\",\"line\":2,\"column\":8}}";
        assert_eq!(json, expected);
        let stopped = Report::from(&Error::Interrupted { resume: Some("--resume".into()) });
        assert_eq!((stopped.exit_code, stopped.resume.as_deref()), (130, Some("--resume")));
        let failed = Error::AllFailed { members: 2, nouns: "tops", first: "x".into() };
        let kept =
            Report::from(&Error::Kept { partial: "a.partial".into(), source: Box::new(failed) });
        assert_eq!((kept.exit_code, kept.kept.as_deref()), (1, Some("a.partial")));
    }
}
