//! Tables of the `.dat` file, in the layout that CalculiX 2.20 prints: a header, an empty line, rows, an empty line.

use super::error::ResultsError;
use crate::model::Totals;
use std::fmt::Write as _;
use std::fs::File;
use std::io::{BufWriter, Write as _};
use std::path::{Path, PathBuf};

/// Stress or strain at one integration point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElementRow {
    /// Label of the element.
    pub element: u64,
    /// Integration point, from 1.
    pub point: usize,
    /// xx yy zz xy yz xz: the order of the fields, not of the table. Strains are tensor components.
    pub values: [f64; 6],
}

/// Values of the constraint of one secondary node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactRow {
    /// Label of the secondary node.
    pub node: u64,
    /// Normal (pressure, or gap negative when overclosed) and two tangential values.
    pub values: [f64; 3],
}

/// The force of a pair on its secondary surface, or its normal or shear part.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PairForce {
    /// Force [F].
    pub force: [f64; 3],
    /// Moment about the origin [F L].
    pub moment: [f64; 3],
    /// Centre of the area in contact [L].
    pub center: [f64; 3],
    /// Mean outward normal of the secondary surface.
    pub normal: [f64; 3],
    /// Area in contact [L²].
    pub area: f64,
    /// Normal force [F], positive in tension.
    pub normal_force: f64,
    /// Size of the shear force [F].
    pub shear_force: f64,
}

impl PairForce {
    /// Moment about the centre of the area in contact [F L]: M − c × F.
    pub fn moment_about_center(&self) -> [f64; 3] {
        let (m, c, f) = (self.moment, self.center, self.force);
        std::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            m[i] - (c[j] * f[k] - c[k] * f[j])
        })
    }
}

/// The `.dat` file of a job. Tables are added in the order of the calls.
#[derive(Debug)]
pub struct Tables {
    path: PathBuf,
    file: BufWriter<File>,
}

impl Tables {
    /// Creates the file; an earlier one is lost.
    pub fn create(path: &Path) -> Result<Self, ResultsError> {
        let file = File::create(path).map_err(|e| ResultsError::file(path, e))?;
        let mut tables = Tables { path: path.into(), file: BufWriter::new(file) };
        tables.add("")?;
        Ok(tables)
    }

    /// Hands all tables to the system: to be called after every increment.
    pub fn flush(&mut self) -> Result<(), ResultsError> {
        self.file.flush().map_err(|e| ResultsError::file(&self.path, e))
    }

    /// U of a node set: `labels` and displacements [L], `[nodes]`, at total time `time` [T].
    pub fn displacements(
        &mut self,
        set: &str,
        time: f64,
        labels: &[u64],
        values: &[[f64; 3]],
    ) -> Result<(), ResultsError> {
        self.vectors("displacements (vx,vy,vz)", (set, time), (labels, values))
    }

    /// V of a node set: `labels` and velocities [L/T], `[nodes]`, at total time `time` [T].
    pub fn velocities(
        &mut self,
        set: &str,
        time: f64,
        labels: &[u64],
        values: &[[f64; 3]],
    ) -> Result<(), ResultsError> {
        self.vectors("velocities (vx,vy,vz)", (set, time), (labels, values))
    }

    fn vectors(
        &mut self,
        title: &str,
        (set, time): (&str, f64),
        (labels, values): (&[u64], &[[f64; 3]]),
    ) -> Result<(), ResultsError> {
        let mut text = for_set(title, set, time);
        node_rows(&mut text, set, labels, values)?;
        self.add(&text)
    }

    /// RF of a node set, its sum, or both: `labels` and reactions [F], `[nodes]`.
    pub fn reactions(
        &mut self,
        set: &str,
        time: f64,
        labels: &[u64],
        values: &[[f64; 3]],
        totals: Totals,
    ) -> Result<(), ResultsError> {
        if totals != Totals::Only {
            self.vectors("forces (fx,fy,fz)", (set, time), (labels, values))?;
        }
        if totals != Totals::No {
            let mut text = for_set("total force (fx,fy,fz)", set, time);
            let sum = values.iter().fold([0.0; 3], |sum, value| std::array::from_fn(|i| sum[i] + value[i]));
            text.push_str("      ");
            numbers(&mut text, &sum);
            text.push('\n');
            self.add(&text)?;
        }
        Ok(())
    }

    /// S of an element set [F/L²].
    pub fn stresses(&mut self, set: &str, time: f64, rows: &[ElementRow]) -> Result<(), ResultsError> {
        let header = for_set("stresses (elem, integ.pnt.,sxx,syy,szz,sxy,sxz,syz)", set, time);
        self.elements(header, rows)
    }

    /// E of an element set.
    pub fn strains(&mut self, set: &str, time: f64, rows: &[ElementRow]) -> Result<(), ResultsError> {
        let header = for_set("strains (elem, integ.pnt.,exx,eyy,ezz,exy,exz,eyz)", set, time);
        self.elements(header, rows)
    }

    /// CSTRESS: pressure and shear stresses of the secondary nodes in contact (a force for a node without area).
    pub fn contact_stresses(&mut self, time: f64, rows: &[ContactRow]) -> Result<(), ResultsError> {
        self.contact("contact stress (slave node,press,tang1,tang2)", time, rows)
    }

    /// CDISP: gap [L], negative when overclosed, and slips [L] of the secondary nodes in contact.
    pub fn contact_displacements(&mut self, time: f64, rows: &[ContactRow]) -> Result<(), ResultsError> {
        self.contact("relative contact displacement (slave node,normal,tang1,tang2)", time, rows)
    }

    /// CF, CFN or CFS of the pair of surfaces `secondary` and `main`.
    pub fn contact_force(
        &mut self,
        secondary: &str,
        main: &str,
        time: f64,
        force: &PairForce,
    ) -> Result<(), ResultsError> {
        let time = fortran(time);
        let mut text = format!(" statistics for slave set {secondary}, master set {main} and time  {time}\n\n");
        for (caption, values) in [
            (
                "total surface force (fx,fy,fz) and moment about the origin (mx,my,mz)",
                &[force.force, force.moment].concat()[..],
            ),
            ("center of gravity and mean normal", &[force.center, force.normal].concat()),
            ("moment about the center of gravity(mx,my,mz)", &force.moment_about_center()),
            (
                "area,  normal force (+ = tension) and shear force (size)",
                &[force.area, force.normal_force, force.shear_force],
            ),
        ] {
            let _ = write!(text, "   {caption}\n\n  ");
            numbers(&mut text, values);
            text.push_str("\n\n");
        }
        text.pop();
        self.add(&text)
    }

    fn elements(&mut self, mut text: String, rows: &[ElementRow]) -> Result<(), ResultsError> {
        for row in rows {
            let [xx, yy, zz, xy, yz, xz] = row.values;
            let _ = write!(text, "{:10}{:4}", row.element, row.point);
            numbers(&mut text, &[xx, yy, zz, xy, xz, yz]);
            text.push('\n');
        }
        self.add(&text)
    }

    fn contact(&mut self, what: &str, time: f64, rows: &[ContactRow]) -> Result<(), ResultsError> {
        let mut text = format!(" {what} for all contact elements and time {}\n\n", fortran(time));
        for row in rows {
            let _ = write!(text, "{:10}", row.node);
            numbers(&mut text, &row.values);
            text.push('\n');
        }
        self.add(&text)
    }

    /// Adds a table and the empty line after it.
    fn add(&mut self, text: &str) -> Result<(), ResultsError> {
        writeln!(self.file, "{text}").map_err(|e| ResultsError::file(&self.path, e))
    }
}

fn for_set(what: &str, set: &str, time: f64) -> String {
    format!(" {what} for set {set} and time  {}\n\n", fortran(time))
}

fn node_rows(text: &mut String, set: &str, labels: &[u64], values: &[[f64; 3]]) -> Result<(), ResultsError> {
    ResultsError::length(format!("nodal values of {set}"), labels.len(), values.len())?;
    for (label, value) in labels.iter().zip(values) {
        let _ = write!(text, "{label:10}");
        numbers(text, value);
        text.push('\n');
    }
    Ok(())
}

/// Columns of numbers with ten significant digits.
fn numbers(text: &mut String, values: &[f64]) {
    for &value in values {
        let _ = write!(text, " {:>17}", scientific(value));
    }
}

/// `-1.234567891E+02`.
fn scientific(value: f64) -> String {
    if !value.is_finite() {
        return if value.is_nan() { "NaN".into() } else { format!("{}Infinity", if value < 0.0 { "-" } else { "" }) };
    }
    let text = format!("{value:.9E}");
    match text.split_once('E').and_then(|(mantissa, power)| Some((mantissa, power.parse::<i32>().ok()?))) {
        Some((mantissa, power)) => format!("{mantissa}E{power:+03}"),
        None => text,
    }
}

/// `0.1000000E+01`: a time as headers have it, not negative.
fn fortran(value: f64) -> String {
    let text = format!("{value:.6E}");
    match text.split_once('E').and_then(|(mantissa, power)| Some((mantissa, power.parse::<i32>().ok()?))) {
        Some((mantissa, power)) => {
            let power = if value == 0.0 { 0 } else { power + 1 };
            format!("0.{}E{power:+03}", mantissa.replace('.', ""))
        }
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_as_fortran_readers_expect() {
        assert_eq!(scientific(-123.456_789_012_3), "-1.234567890E+02");
        assert_eq!(scientific(1e-105), "1.000000000E-105");
        assert_eq!(scientific(0.0), "0.000000000E+00");
        assert_eq!(scientific(f64::NAN), "NaN");
        assert_eq!(scientific(f64::NEG_INFINITY), "-Infinity");
        for (time, text) in [
            (1.0, "0.1000000E+01"),
            (0.0, "0.0000000E+00"),
            (0.25, "0.2500000E+00"),
            (0.999_999_99, "0.1000000E+01"),
            (12_345.678, "0.1234568E+05"),
            (2e-7, "0.2000000E-06"),
        ] {
            assert_eq!(fortran(time), text);
        }
    }

    /// A force of 24 upwards through (0.5, 0.5, 1) turns about the origin by (12, −12, 0) and not about that point.
    #[test]
    fn the_moment_about_the_center_of_a_force_through_it_vanishes() {
        let (force, moment, center) = ([0.0, 0.0, 24.0], [12.0, -12.0, 0.0], [0.5, 0.5, 1.0]);
        assert_eq!(PairForce { force, moment, center, ..Default::default() }.moment_about_center(), [0.0; 3]);
    }
}
