//! Words of the job as values of an argument: names and descriptions are those of the job's schema.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use schemars::JsonSchema;
use serde::de::DeserializeOwned;

/// Reads a variant without fields by its word, and lists all of them in the help.
pub fn parser<T>() -> impl TypedValueParser<Value = T>
where
    T: JsonSchema + DeserializeOwned + Clone + Send + Sync + 'static,
{
    PossibleValuesParser::new(listed::<T>()).try_map(|word| serde_json::from_value::<T>(word.into()))
}

fn listed<T: JsonSchema>() -> Vec<PossibleValue> {
    let schema = crate::settings::schema::<T>();
    let variants = schema.get("oneOf").and_then(serde_json::Value::as_array);
    let listed = variants.into_iter().flatten().filter_map(|variant| {
        let about = variant.get("description")?.as_str()?.trim_end_matches('.').to_owned();
        Some(PossibleValue::new(variant.get("const")?.as_str()?.to_owned()).help(about))
    });
    listed.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::artifact::blade::Unit;
    use crate::artifact::program::{Control, Programmed};

    #[test]
    fn every_variant_is_listed_and_read() {
        let words = |listed: Vec<PossibleValue>| listed.iter().map(|v| v.get_name().to_owned()).collect::<Vec<_>>();
        assert_eq!(words(listed::<Control>()), Control::ALL.map(|c| c.to_string()));
        assert_eq!(words(listed::<Unit>()), ["mm", "cm", "m", "inch"]);
        assert_eq!(words(listed::<Programmed>()), ["tip", "centre", "machine"]);
        let command = clap::Command::new("a").arg(clap::Arg::new("control").value_parser(parser::<Control>()));
        for control in Control::ALL {
            let read = command.clone().try_get_matches_from(["a".to_owned(), control.to_string()]).expect("a control");
            assert_eq!(read.get_one::<Control>("control"), Some(&control));
        }
        assert!(command.try_get_matches_from(["a", "heidenhein"]).is_err());
    }
}
