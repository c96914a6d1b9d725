//! A small reader of both dialects: motion lines to positions, nothing shared with the writers.

/// Position after a motion line.
#[derive(Clone, Debug)]
pub struct Move {
    /// Number of the line, from 1.
    pub line: usize,
    /// X, Y, Z, A, B after it, as programmed.
    pub at: [f64; 5],
    /// The F in force.
    pub feed: f64,
    /// G93 is in force.
    pub inverse_time: bool,
    /// TRAORI is in force.
    pub traori: bool,
}

/// Reads a program: `Err` with the line that it does not understand.
pub fn read(text: &str) -> Result<Vec<Move>, String> {
    let mut now = Move { line: 0, at: [0.0; 5], feed: 0.0, inverse_time: false, traori: false };
    let mut out = Vec::new();
    for (i, line) in text.lines().enumerate() {
        now.line = i + 1;
        let code = line.split(';').next().unwrap_or("");
        if code.contains("CYCLE832") {
            continue;
        }
        let words: Vec<&str> = code.split_whitespace().collect();
        // A move in machine coordinates says nothing about the work's.
        let machine = words.iter().any(|w| ["SUPA", "G53"].contains(w));
        let (mut moved, mut feed) = (false, None);
        for word in words {
            match word {
                "G93" => now.inverse_time = true,
                "G94" => now.inverse_time = false,
                "TRAORI" => now.traori = true,
                "TRAFOOF" => now.traori = false,
                "SUPA" | "COMPOF" | "SOFT" | "FFWON" | "ORIWKS" | "ORIAXES" => {}
                _ => {
                    let (letter, value) = word.split_at(1);
                    let called = |name: &str| value.strip_prefix(name).and_then(|v| v.strip_suffix(')'));
                    let (step, shorter) = (called("=IC("), called("=DC("));
                    let plain = step.or(shorter).or(called("=AC(")).unwrap_or(value.trim_start_matches('='));
                    let number: f64 = plain.parse().map_err(|_| format!("line {}: {word}", i + 1))?;
                    match ("XYZAB".find(letter), letter) {
                        (Some(_), _) if machine => {}
                        (Some(k), _) => {
                            now.at[k] = match (step, shorter) {
                                (Some(_), _) => now.at[k] + number,
                                (_, Some(_)) => number + 360.0 * ((now.at[k] - number) / 360.0).round(),
                                _ => number,
                            };
                            moved = true;
                        }
                        (None, "F") => feed = Some(number),
                        (None, "N" | "G" | "T" | "D" | "S" | "M" | "P") => {}
                        _ => return Err(format!("line {}: {word}", i + 1)),
                    }
                }
            }
        }
        now.feed = feed.unwrap_or(now.feed);
        if moved {
            if now.inverse_time && feed.is_none() {
                return Err(format!("line {}: no F under G93", i + 1));
            }
            out.push(now.clone());
        }
    }
    Ok(out)
}
