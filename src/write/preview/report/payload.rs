//! What the page's script draws, as it stands in the page: three script elements that are not run.

use serde_json::Value;

use super::pack::Pack;
use super::{ReportInput, data, scene};
use crate::error::{Error, Result, Stage};

/// Elements by their names and types, in order.
const ELEMENTS: [(&str, &str); 3] =
    [("data", "application/json"), ("numbers", "text/plain"), ("scene-glb", "text/plain")];

/// The data of plots and 3-D view.
#[derive(Clone, Debug, PartialEq)]
pub struct Payload([String; 3]);

impl Payload {
    /// The payload of a run.
    ///
    /// # Errors
    /// `InputOutput` where the data cannot be encoded; numbers that are not finite are shown as
    /// missing.
    pub fn of(input: &ReportInput) -> Result<Self> {
        let mut pack = Pack::default();
        let data = data::payload(input, &mut pack);
        Payload::made(&data, &pack, scene::glb(input))
    }

    /// The payload of data, the lists that it refers to, and a scene. A coordinate that is not a
    /// number leaves the page without its picture, not the user without the page.
    pub(super) fn made(data: &Value, pack: &Pack, glb: Result<String>) -> Result<Self> {
        let data = serde_json::to_string(data)
            .map_err(|e| Error::io(Stage::Preview, format!("the report's data cannot be encoded: {e}")).caused_by(e))?
            // Inside a script element the text must not contain `</script` or `<!--`.
            .replace('<', "\\u003c");
        Ok(Payload([data, pack.text()?, glb.unwrap_or_default()]))
    }

    /// The payload of a page that was made before; `None` where the text is no such page.
    pub fn of_page(page: &str) -> Option<Self> {
        let mut rest = page;
        let mut texts = Vec::new();
        for (id, kind) in ELEMENTS {
            // Words of the page are escaped: its own elements alone look like this, and none of the
            // texts has a `<`.
            let (_, after) = rest.split_once(&start(id, kind))?;
            let (text, after) = after.split_once('<')?;
            texts.push(text.to_owned());
            rest = after;
        }
        Some(Payload(texts.try_into().ok()?))
    }

    /// Bytes of all texts.
    pub(super) fn len(&self) -> usize {
        self.0.iter().map(String::len).sum()
    }

    pub(super) fn write(&self, page: &mut String) {
        for ((id, kind), text) in ELEMENTS.into_iter().zip(&self.0) {
            page.push_str(&start(id, kind));
            page.push_str(text);
            page.push_str("</script>\n");
        }
    }
}

fn start(id: &str, kind: &str) -> String {
    format!("<script id=\"{id}\" type=\"{kind}\">")
}
