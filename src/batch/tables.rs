//! `family.csv` and `family.parquet`.

use std::sync::Arc;

use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::{Type, TypePtr};

use super::columns::{Column, TableCell};
use crate::error::{Error, Result, Stage};

/// The columns as CSV with a header; empty cells are empty, texts are quoted where they must be.
///
/// # Errors
/// Kind `InputOutput` where the text cannot be made.
pub(super) fn csv(columns: &[Column]) -> Result<Vec<u8>> {
    let trouble = |e: String| Error::io(Stage::Output, format!("family.csv cannot be made: {e}"));
    let mut out = csv::Writer::from_writer(Vec::new());
    out.write_record(columns.iter().map(|c| &c.name)).map_err(|e| trouble(e.to_string()))?;
    for row in 0..columns.first().map_or(0, |c| c.cells.len()) {
        let cells = columns.iter().map(|c| c.cells.get(row).map(TableCell::to_string).unwrap_or_default());
        out.write_record(cells).map_err(|e| trouble(e.to_string()))?;
    }
    out.into_inner().map_err(|e| trouble(e.to_string()))
}

/// The columns as Parquet, one row group, plain encoding, no compression: integers, doubles,
/// booleans and UTF-8, all optional.
///
/// # Errors
/// Kind `InputOutput` where the file cannot be made.
pub(super) fn parquet(columns: &[Column]) -> Result<Vec<u8>> {
    write(columns).map_err(|e| Error::io(Stage::Output, format!("family.parquet cannot be made: {e}")).caused_by(e))
}

fn physical(column: &Column) -> Physical {
    match column.cells.iter().find(|c| **c != TableCell::Empty) {
        Some(TableCell::Integer(_)) => Physical::INT64,
        Some(TableCell::Number(_)) => Physical::DOUBLE,
        Some(TableCell::Truth(_)) => Physical::BOOLEAN,
        _ => Physical::BYTE_ARRAY,
    }
}

fn write(columns: &[Column]) -> std::result::Result<Vec<u8>, ParquetError> {
    let field = |c: &Column| -> std::result::Result<TypePtr, ParquetError> {
        let kind = physical(c);
        let logical = (kind == Physical::BYTE_ARRAY).then_some(LogicalType::String);
        let field = Type::primitive_type_builder(&c.name, kind).with_repetition(Repetition::OPTIONAL);
        Ok(Arc::new(field.with_logical_type(logical).build()?))
    };
    let fields = columns.iter().map(field).collect::<std::result::Result<Vec<_>, _>>()?;
    let schema = Arc::new(Type::group_type_builder("family").with_fields(fields).build()?);
    let properties = WriterProperties::builder().set_created_by(crate::run::program()).build();
    let mut file = SerializedFileWriter::new(Vec::new(), schema, Arc::new(properties))?;
    let mut group = file.next_row_group()?;
    for c in columns {
        match physical(c) {
            Physical::INT64 => put::<Int64Type>(&mut group, c, |x| match x {
                TableCell::Integer(i) => Some(*i),
                _ => None,
            })?,
            Physical::DOUBLE => put::<DoubleType>(&mut group, c, |x| match x {
                TableCell::Number(v) => Some(*v),
                _ => None,
            })?,
            Physical::BOOLEAN => put::<BoolType>(&mut group, c, |x| match x {
                TableCell::Truth(b) => Some(*b),
                _ => None,
            })?,
            _ => put::<ByteArrayType>(&mut group, c, |x| match x {
                TableCell::Text(s) => Some(ByteArray::from(s.as_str())),
                _ => None,
            })?,
        }
    }
    group.close()?;
    file.into_inner()
}

/// One column; `value`: `None` for an empty cell.
fn put<T: DataType>(
    group: &mut SerializedRowGroupWriter<'_, Vec<u8>>,
    column: &Column,
    value: impl Fn(&TableCell) -> Option<T::T>,
) -> std::result::Result<(), ParquetError> {
    let Some(mut writer) = group.next_column()? else {
        return Err(ParquetError::General("fewer columns than were declared".into()));
    };
    let cells: Vec<Option<T::T>> = column.cells.iter().map(value).collect();
    let levels: Vec<i16> = cells.iter().map(|c| i16::from(c.is_some())).collect();
    let values: Vec<T::T> = cells.into_iter().flatten().collect();
    writer.typed::<T>().write_batch(&values, Some(&levels), None)?;
    writer.close()
}
