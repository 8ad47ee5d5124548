//! The tables of the `.dat` file: headers word for word as CalculiX 2.20 prints them.
#![allow(clippy::unwrap_used)]

use fe_io::model::Totals;
use fe_io::results::{ContactRow, ElementRow, PairForce, ResultsError, Tables};
use std::path::Path;

const EXPECTED: &str = "
 displacements (vx,vy,vz) for set TOP and time  0.5000000E+00

         7   0.000000000E+00  -1.000000000E-01   2.500000000E+00
    123456   3.333333333E-01   1.000000000E+10               NaN

 forces (fx,fy,fz) for set BOT and time  0.5000000E+00

         1   1.000000000E+00   2.000000000E+00   3.000000000E+00
         2   1.000000000E+01   2.000000000E+01   3.000000000E+01

 total force (fx,fy,fz) for set BOT and time  0.5000000E+00

         1.100000000E+01   2.200000000E+01   3.300000000E+01

 total force (fx,fy,fz) for set BOT and time  0.1000000E+01

         1.000000000E+00   2.000000000E+00   3.000000000E+00

 stresses (elem, integ.pnt.,sxx,syy,szz,sxy,sxz,syz) for set EALL and time  0.1000000E+01

         4   8   1.000000000E+00   2.000000000E+00   3.000000000E+00   4.000000000E+00   6.000000000E+00   5.000000000E+00

 strains (elem, integ.pnt.,exx,eyy,ezz,exy,exz,eyz) for set EALL and time  0.1000000E+01

         4   8   1.000000000E+00   2.000000000E+00   3.000000000E+00   4.000000000E+00   6.000000000E+00   5.000000000E+00

 contact stress (slave node,press,tang1,tang2) for all contact elements and time 0.1000000E+01

        11   2.380952000E+01   0.000000000E+00   0.000000000E+00

 relative contact displacement (slave node,normal,tang1,tang2) for all contact elements and time 0.1000000E+01

        11  -2.380952000E-03   0.000000000E+00   0.000000000E+00

 statistics for slave set SS, master set SM and time  0.1000000E+01

   total surface force (fx,fy,fz) and moment about the origin (mx,my,mz)

     0.000000000E+00   0.000000000E+00   2.400000000E+01   1.200000000E+01  -1.200000000E+01   0.000000000E+00

   center of gravity and mean normal

     5.000000000E-01   5.000000000E-01   1.000000000E+00   0.000000000E+00   0.000000000E+00  -1.000000000E+00

   moment about the center of gravity(mx,my,mz)

     0.000000000E+00   0.000000000E+00   0.000000000E+00

   area,  normal force (+ = tension) and shear force (size)

     1.000000000E+00  -2.400000000E+01   0.000000000E+00

";

#[test]
fn tables_have_the_layout_that_readers_know() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("results_tables.dat");
    let mut tables = Tables::create(&path).unwrap();
    tables.displacements("TOP", 0.5, &[7, 123456], &[[0.0, -0.1, 2.5], [1.0 / 3.0, 1e10, f64::NAN]]).unwrap();
    let forces = [[1.0, 2.0, 3.0], [10.0, 20.0, 30.0]];
    tables.reactions("BOT", 0.5, &[1, 2], &forces, Totals::Yes).unwrap();
    tables.reactions("BOT", 1.0, &[1], &forces[..1], Totals::Only).unwrap();
    let row = ElementRow { element: 4, point: 8, values: [1.0, 2.0, 3.0, 4.0, 5.0, 6.0] };
    tables.stresses("EALL", 1.0, &[row]).unwrap();
    tables.strains("EALL", 1.0, &[row]).unwrap();
    tables.contact_stresses(1.0, &[ContactRow { node: 11, values: [23.80952, 0.0, 0.0] }]).unwrap();
    tables.contact_displacements(1.0, &[ContactRow { node: 11, values: [-0.002380952, 0.0, 0.0] }]).unwrap();
    let force = PairForce {
        force: [0.0, 0.0, 24.0],
        moment: [12.0, -12.0, 0.0],
        center: [0.5, 0.5, 1.0],
        normal: [0.0, 0.0, -1.0],
        area: 1.0,
        normal_force: -24.0,
        shear_force: 0.0,
    };
    tables.contact_force("SS", "SM", 1.0, &force).unwrap();
    tables.flush().unwrap();
    assert_eq!(std::fs::read_to_string(&path).unwrap(), EXPECTED);
}

#[test]
fn a_table_whose_columns_differ_in_length_is_refused() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("results_tables_refused.dat");
    let mut tables = Tables::create(&path).unwrap();
    let refused = tables.displacements("TOP", 0.5, &[7], &[]);
    assert!(matches!(refused, Err(ResultsError::Length { expected: 1, found: 0, .. })));
    assert!(matches!(Tables::create(Path::new("no/such/folder/x.dat")), Err(ResultsError::File { .. })));
}
