//! Ready-made designs.
use super::design::{Accuracy, AirfoilDesign, BladeDesign, Law, OutlinePoint, PlatformDesign, PrismDesign};

/// Makes a preset's design.
pub type Preset = fn() -> BladeDesign;

/// Name and maker of every preset.
pub const ALL: [(&str, Preset); 4] = [
    ("steam_root", steam_root),
    ("compressor_twist", compressor_twist),
    ("turbine_camber", turbine_camber),
    ("prism", prism),
];

/// A preset by name.
pub fn by_name(name: &str) -> Option<BladeDesign> {
    ALL.iter().find(|(n, _)| *n == name).map(|(_, make)| make())
}

fn law<const N: usize>(stations: [[f64; 2]; N]) -> Law {
    Law::Stations(stations.to_vec())
}

fn outline<const N: usize>(points: [[f64; 2]; N]) -> Vec<OutlinePoint> {
    points.map(|[depth_mm, half_width_mm]| OutlinePoint { depth_mm, half_width_mm }).to_vec()
}

/// Root region of a large marine steam turbine blade, to be cut with a ball of radius 8.
pub fn steam_root() -> BladeDesign {
    BladeDesign {
        name: "steam_root".into(),
        height_mm: 200.0,
        fillet_radius_mm: 11.0,
        airfoil: Some(AirfoilDesign {
            chord_mm: law([[0.0, 118.0], [1.0, 104.0]]),
            stagger_deg: law([[0.0, 12.0], [0.5, 18.0], [1.0, 27.0]]),
            inlet_deg: law([[0.0, 34.0], [1.0, 24.0]]),
            outlet_deg: law([[0.0, 28.0], [1.0, 20.0]]),
            thickness_mm: law([[0.0, 20.0], [1.0, 16.5]]),
            thickness_at: Law::Constant(0.40),
            leading_radius_mm: law([[0.0, 3.2], [1.0, 3.0]]),
            trailing_radius_mm: law([[0.0, 1.7], [1.0, 1.5]]),
            stack_at: 0.5,
            sweep_mm: Law::Constant(0.0),
            lean_mm: law([[0.0, 0.0], [1.0, 4.0]]),
        }),
        prism: None,
        platform: PlatformDesign {
            length_mm: 150.0,
            top_z_mm: 0.0,
            shear_deg: 10.0,
            offset_x_mm: 0.0,
            offset_y_mm: -8.0,
            outline: outline([[0.0, 45.0], [26.0, 45.0], [26.0, 24.0], [44.0, 24.0], [60.0, 36.0], [74.0, 36.0]]),
        },
        accuracy: Accuracy::default(),
    }
}

/// A thin, strongly twisted compressor blade, for a ball of radius 2.5.
pub fn compressor_twist() -> BladeDesign {
    BladeDesign {
        name: "compressor_twist".into(),
        height_mm: 90.0,
        fillet_radius_mm: 3.0,
        airfoil: Some(AirfoilDesign {
            chord_mm: law([[0.0, 45.0], [1.0, 42.0]]),
            stagger_deg: law([[0.0, 14.0], [0.5, 40.0], [1.0, 58.0]]),
            inlet_deg: law([[0.0, 22.0], [1.0, 8.0]]),
            outlet_deg: law([[0.0, 18.0], [1.0, 6.0]]),
            thickness_mm: law([[0.0, 4.4], [1.0, 2.6]]),
            thickness_at: Law::Constant(0.46),
            leading_radius_mm: law([[0.0, 0.32], [1.0, 0.17]]),
            trailing_radius_mm: law([[0.0, 0.28], [1.0, 0.15]]),
            stack_at: 0.48,
            sweep_mm: Law::Constant(0.0),
            lean_mm: Law::Constant(0.0),
        }),
        prism: None,
        platform: PlatformDesign {
            length_mm: 58.0,
            top_z_mm: 30.0,
            shear_deg: 14.0,
            offset_x_mm: 0.0,
            offset_y_mm: -1.5,
            outline: outline([[0.0, 13.0], [6.0, 13.0], [6.0, 6.5], [11.0, 6.5], [18.0, 11.0], [24.0, 11.0]]),
        },
        accuracy: Accuracy { stations: 192, rows: 32, ..Accuracy::default() },
    }
}

/// A small turbine blade with high camber and a deep concave side, for a ball of radius 2.
pub fn turbine_camber() -> BladeDesign {
    BladeDesign {
        name: "turbine_camber".into(),
        height_mm: 40.0,
        fillet_radius_mm: 2.5,
        airfoil: Some(AirfoilDesign {
            chord_mm: law([[0.0, 28.0], [1.0, 27.0]]),
            stagger_deg: law([[0.0, 8.0], [1.0, 14.0]]),
            inlet_deg: law([[0.0, 50.0], [1.0, 44.0]]),
            outlet_deg: law([[0.0, 48.0], [1.0, 46.0]]),
            thickness_mm: law([[0.0, 5.4], [1.0, 4.4]]),
            thickness_at: Law::Constant(0.42),
            leading_radius_mm: law([[0.0, 0.7], [1.0, 0.6]]),
            trailing_radius_mm: law([[0.0, 0.45], [1.0, 0.4]]),
            stack_at: 0.5,
            sweep_mm: Law::Constant(0.0),
            lean_mm: Law::Constant(0.0),
        }),
        prism: None,
        platform: PlatformDesign {
            length_mm: 40.0,
            top_z_mm: 0.0,
            shear_deg: 8.0,
            offset_x_mm: 0.0,
            offset_y_mm: -3.0,
            outline: outline([[0.0, 14.0], [6.0, 14.0], [6.0, 8.0], [20.0, 8.0]]),
        },
        accuracy: Accuracy { stations: 160, rows: 20, deflection_mm: 0.005 },
    }
}

/// A straight stadium prism with a toroidal fillet: every stage has a closed form.
pub fn prism() -> BladeDesign {
    BladeDesign {
        name: "prism".into(),
        height_mm: 80.0,
        fillet_radius_mm: 6.0,
        airfoil: None,
        prism: Some(PrismDesign { length_mm: 60.0, width_mm: 20.0, stagger_deg: 0.0 }),
        platform: PlatformDesign {
            length_mm: 90.0,
            top_z_mm: 0.0,
            shear_deg: 0.0,
            offset_x_mm: 0.0,
            offset_y_mm: 0.0,
            outline: outline([[0.0, 25.0], [20.0, 25.0], [20.0, 12.0], [50.0, 12.0]]),
        },
        accuracy: Accuracy::default(),
    }
}
