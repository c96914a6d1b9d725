//! IGES files as a writer makes them: entities in, text of 80 columns out.

use std::fmt::Write;

/// Entities of a file.
#[derive(Default)]
pub struct Sheet {
    entities: Vec<Record>,
}

struct Record {
    kind: u32,
    form: i64,
    transform: usize,
    subordinate: bool,
    text: String,
}

/// A list of numbers with commas.
pub fn list(numbers: &[f64]) -> String {
    numbers.iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(",")
}

impl Sheet {
    /// Adds an entity; its directory line.
    pub fn add(&mut self, kind: u32, form: i64, parameters: impl AsRef<str>) -> usize {
        let text = format!("{kind},{};", parameters.as_ref());
        self.entities.push(Record { kind, form, transform: 0, subordinate: false, text });
        2 * self.entities.len() - 1
    }
    /// More parameters behind those that an entity has.
    pub fn append(&mut self, entity: usize, parameters: impl AsRef<str>) {
        let text = &mut self.entities[entity / 2].text;
        text.pop();
        *text += parameters.as_ref();
        text.push(';');
    }
    /// Entities so far.
    pub fn len(&self) -> usize {
        self.entities.len()
    }
    /// The type number of an entity.
    pub fn kind(&self, entity: usize) -> u32 {
        self.entities[entity / 2].kind
    }
    /// Places an entity.
    pub fn place(&mut self, entity: usize, transform: usize) {
        self.entities[entity / 2].transform = transform;
    }
    /// A transform with these twelve numbers, itself placed by another (0: not).
    pub fn transform(&mut self, rows: [f64; 12], by: usize) -> usize {
        let t = self.add(124, 0, list(&rows));
        self.place(t, by);
        t
    }
    pub fn line(&mut self, a: [f64; 3], b: [f64; 3]) -> usize {
        self.add(110, 0, list(&[a, b].concat()))
    }
    pub fn composite(&mut self, members: &[usize]) -> usize {
        let ids: Vec<String> = members.iter().map(ToString::to_string).collect();
        self.add(102, 0, format!("{},{}", members.len(), ids.join(",")))
    }
    /// A closed polygon of lines.
    pub fn polygon(&mut self, corners: &[[f64; 3]]) -> usize {
        let n = corners.len();
        let lines: Vec<usize> = (0..n).map(|k| self.line(corners[k], corners[(k + 1) % n])).collect();
        self.composite(&lines)
    }
    /// A bilinear 128 over [0, 1]².
    pub fn bilinear(&mut self, [a, b, c, d]: [[f64; 3]; 4]) -> usize {
        // Along u first: (0,0), (1,0), (0,1), (1,1).
        let knots = "0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.";
        let points = list(&[a, b, d, c].concat());
        self.add(128, 0, format!("1,1,1,1,0,0,1,0,0,{knots},{points},0.,1.,0.,1."))
    }
    /// A plane 108 through three points.
    pub fn plane(&mut self, [a, b, c, _]: [[f64; 3]; 4]) -> usize {
        let [u, v] = [b, c].map(|p| [0, 1, 2].map(|k| p[k] - a[k]));
        let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        let d = n[0] * a[0] + n[1] * a[1] + n[2] * a[2];
        self.add(108, 0, format!("{},0,0.,0.,0.,0.", list(&[n[0], n[1], n[2], d])))
    }
    /// A trimmed face from a surface and boundaries, each (curve in the parameter plane, curve in
    /// space; 0 for none).
    pub fn trimmed(&mut self, surface: usize, boundaries: &[(usize, usize)]) -> usize {
        let ids: Vec<usize> = boundaries
            .iter()
            .map(|(flat, space)| {
                let prefer = if *space == 0 { 1 } else { 2 };
                let id = self.add(142, 0, format!("1,{surface},{flat},{space},{prefer}"));
                self.entities[id / 2].subordinate = true;
                id
            })
            .collect();
        self.entities[surface / 2].subordinate = true;
        let inner: Vec<String> = ids[1..].iter().map(|i| format!(",{i}")).collect();
        self.add(144, 0, format!("{surface},1,{},{}{}", ids.len() - 1, ids[0], inner.concat()))
    }
    /// A full circle about z, counter-clockwise from angle `from`.
    pub fn circle(&mut self, radius: f64, z: f64, from: f64) -> usize {
        let (x, y) = (radius * from.cos(), radius * from.sin());
        self.add(100, 0, list(&[z, 0.0, 0.0, x, y, x, y]))
    }
    /// The file, in millimetres.
    pub fn text(&self) -> String {
        self.text_in("2,2HMM", 1.0)
    }
    /// The file, in a unit (flag and name) and a model scale.
    pub fn text_in(&self, unit: &str, scale: f64) -> String {
        let mut out = String::new();
        let mut line = |body: &str, section: char, n: usize| {
            writeln!(out, "{body:<72}{section}{n:>7}").expect("a String takes everything");
        };
        line("written by a test", 'S', 1);
        let global = format!("1H,,1H;,4Htest,8Htest.igs,4Htest,1H1,32,38,6,308,15,4Htest,{scale:?},{unit},1,0.01,");
        let global = global + "15H20200101.000000,1.E-6,100.,2Hme,2Hus,11,0,15H20200101.000000;";
        let rows = chunks(&global, 72);
        rows.iter().enumerate().for_each(|(k, r)| line(r, 'G', k + 1));
        let mut parameters = Vec::new();
        for (k, e) in self.entities.iter().enumerate() {
            let rows = chunks(&e.text, 64);
            let status = if e.subordinate { "00010000" } else { "00000000" };
            let first = parameters.len() + 1;
            let (d, n) = (2 * k + 1, rows.len());
            let one =
                format!("{:>8}{first:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{status}", e.kind, 0, 0, 0, 0, e.transform, 0);
            line(&one, 'D', d);
            line(&format!("{:>8}{:>8}{:>8}{n:>8}{:>8}", e.kind, 0, 0, e.form), 'D', d + 1);
            parameters.extend(rows.into_iter().map(|r| format!("{r:<64}{d:>8}")));
        }
        parameters.iter().enumerate().for_each(|(k, r)| line(r, 'P', k + 1));
        line(&format!("S{:>7}G{:>7}D{:>7}P{:>7}", 1, rows.len(), 2 * self.entities.len(), parameters.len()), 'T', 1);
        out
    }
}

/// Text in lines of at most so many columns, broken behind commas where there are some.
fn chunks(text: &str, width: usize) -> Vec<String> {
    let mut out = vec![];
    let mut rest = text;
    while rest.len() > width {
        let at = rest[..width].rfind(',').map_or(width, |k| k + 1);
        out.push(rest[..at].to_owned());
        rest = &rest[at..];
    }
    out.push(rest.to_owned());
    out
}

/// Sides of the box from the origin, corners counter-clockwise seen from outside.
pub fn box_sides(size: [f64; 3]) -> [[[f64; 3]; 4]; 6] {
    let at = |k: usize| [0, 1, 2].map(|d| if k >> d & 1 == 1 { size[d] } else { 0.0 });
    [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]].map(|r| r.map(at))
}
