#![allow(clippy::unwrap_used)]
use super::*;

#[test]
#[ignore = "writes files for trying out"]
fn dump() {
    let dir = std::path::PathBuf::from(std::env::var("DUMP").unwrap());
    for (name, make) in presets::ALL {
        std::fs::write(dir.join(format!("{name}.toml")), make().to_toml().unwrap()).unwrap();
        match build(&make()) {
            Ok(b) => {
                eprintln!(
                    "{name}: {} faces, {} pts {} tris, defl {}, vol {}",
                    b.brep.faces.len(),
                    b.mesh.points.len(),
                    b.mesh.triangles.len(),
                    b.deflection_mm,
                    b.mesh.volume_mm3()
                );
                write_step(&b, &dir.join(format!("{name}.step"))).unwrap();
                write_obj(&b, &dir.join(format!("{name}.obj"))).unwrap();
            }
            Err(e) => eprintln!("{name}: {e}"),
        }
    }
}
