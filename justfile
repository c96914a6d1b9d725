# The commands of the house; `just ci` is what CI runs.

default:
    @just --list

# The tests that run on every change
test:
    cargo nextest run --release

# Everything that CI runs
ci:
    bash .ci/run

# Real blades in the folder BLADEWRIGHT_BLADES (not part of the repository)
corpus:
    cargo nextest run --release --run-ignored only -E 'test(/^corpus(_edges|_open)?::/)'

# Sections of the same blades with their leading (red) and trailing edges (blue), in out/edges.svg
edges:
    BLADEWRIGHT_EDGES_SHEET=out/edges.svg cargo nextest run --release --run-ignored only -E 'test(/^corpus_edges::/)'

# Tools on the channel's walls touch nothing, a fifth of a degree outside what the channel names
walls:
    cargo nextest run --release --run-ignored only --no-capture -E 'test(/^walls::walls_of/)'

# The same for the real blades in the folder BLADEWRIGHT_BLADES
real-walls:
    cargo nextest run --release --run-ignored only --no-capture -E 'test(/^walls::real_walls_of/)'

# Lints of the feature s3, whose client of object stores CI does not compile
lint-s3:
    cargo clippy --release --all-targets --features s3 -- -D warnings

# What `inspect` and `plan` make of each of them, as a table
corpus-table:
    cargo nextest run --release --run-ignored only --no-capture -E 'test(/^corpus_table::/)'

# The length is in seconds (600) or executions (1000000x) for each of the formats, which are all,
# models, programs, or names.
# Mutated models and programs against every reader
fuzz length="600" formats="all":
    cargo run --release --example fuzz_readers -- {{length}} {{formats}}

# Needs Python (PYTHON=...) with `pip install opencamlib`.
# Bull-nose and flat cutters on triangles beside OpenCAMLib
opencamlib places="2000":
    cargo build --release --example drop_cutter
    "${PYTHON:-python3}" tests/opencamlib/compare.py target/release/examples/drop_cutter {{places}}

# Needs Python (PYTHON=...) with `pip install cadquery-ocp numpy`, as do `occ-dense`, `occ-entities` and `occ-load`.
# Closest points, inside, area and volume beside OpenCASCADE
occ points="10000" *models="models/steam_root.step models/compressor_twist.step models/turbine_camber.step models/prism.step":
    cargo build --release --examples --bins
    "${PYTHON:-python3}" tests/occ/compare.py target/release {{points}} {{models}}

# The same where its search over all faces takes too long: its local search from many starts
occ-dense points="10000" *models="models/steam_root.step":
    cargo build --release --examples --bins
    "${PYTHON:-python3}" tests/occ/dense.py target/release {{points}} {{models}}

# Each is to be closed, with its area and volume.
# Every kind of face, file and unit of STEP and IGES as OpenCASCADE writes them
occ-entities:
    cargo build --release --bins
    "${PYTHON:-python3}" tests/occ/entities.py target/release

# Needs Python (PYTHON=...) with `pip install cadquery`.
# Blades drawn at random: `inspect` finds their axis, and with --plan they are planned at defaults
drawn count="40" *options="":
    cargo build --release --bins
    "${PYTHON:-python3}" tests/occ/drawn.py target/release/bladewright {{count}} {{options}}

# Models may be meshes (STL, OBJ), MODEL@m is one in metres whatever it says.
# Loading time beside OpenCASCADE
occ-load *models="models/steam_root.step models/compressor_twist.step models/turbine_camber.step models/prism.step":
    cargo build --release --examples
    "${PYTHON:-python3}" tests/occ/load.py target/release {{models}}

# Free angles against brute force and parry3d: tens of thousands of random tools, parts and moves
brute times="50":
    BLADEWRIGHT_CASES={{times}} cargo nextest run --release --lib channel::tests::brute

# Needs Python 3.11.
# Motions of the project's blades, differentiated by code that did not plan them
motion:
    cargo build --release
    bash tests/motion/run.sh target/release/bladewright

# The channel of 100 000 locations beside generic collision tests
bench-channel:
    cargo bench --bench channel

# The interpreters are of apt (linuxcnc-uspace) and PyPI. Kinematics are compared with LinuxCNC's.
# Programs of the examples read by LinuxCNC's interpreter and nc-gcode-interpreter
controls:
    cargo build --release --bins --example axis_positions
    bash tests/controls/run.sh target/release/bladewright target/release/examples/axis_positions

# Needs Python (PYTHON=...) with `pip install numpy scipy toppra copp-py`.
# The feed beside toppra and copp, and seconds for 100 000 locations
bench-feed locations="2000":
    BLADEWRIGHT_PEERS="${PYTHON:-python3} tests/motion/peers.py" cargo bench --bench feed -- --locations={{locations}}

# Closest points a second, beside parry's query to the triangles
bench:
    cargo bench --bench closest

# Needs Node 20 and chromium.
# Reports, previews and a family's page in headless Chromium and Khronos' validator
look:
    bash viewer/test/run.sh

# The pictures of README and examples, made anew from runs of the examples
pictures:
    PICTURES=1 bash viewer/test/run.sh

# The scripts of report.html and family.html anew from viewer/src and the pinned packages
viewer:
    cd viewer && npm ci && npm run build

# The Python package as a wheel, in a fresh environment, beside the command: Python 3.11
python:
    cargo build --release
    bash python/test.sh target/release/bladewright

# The archive of a release for this system, unpacked and tried: Python 3.11
archive:
    "${PYTHON:-python3}" release/archive.py

# The licences of all that is in the programs; fails where one is not permissive: Python 3.11
notices:
    "${PYTHON:-python3}" release/notices.py
    "${PYTHON:-python3}" -m unittest discover release

# The example program
plan:
    cargo run --release -- plan models/steam_root.step -o out/steam_root

# Families killed at random moments and started again: the same bytes
kill runs="100":
    BLADEWRIGHT_RUNS={{runs}} cargo nextest run --release --run-ignored only --no-capture -E 'test(/^batch_kill::/)'

# Needs root and `apt-get install slurmctld slurmd slurm-client munge`.
# A family as an array job on a real Slurm on this machine
slurm:
    cargo build --release
    bash tests/slurm/run.sh target/release/bladewright

# Needs Python (PYTHON=...) with `pip install kubernetes-validate pyyaml`.
# The Kubernetes Jobs' schemas and commands, without a cluster
kubernetes:
    cargo build --release
    bash tests/kubernetes/run.sh target/release/bladewright

# Needs Python (PYTHON=...) with `pip install "moto[server]" boto3`.
# A family on S3-compatible storage on this machine
s3:
    cargo build --release --features s3
    bash tests/s3/run.sh target/release/bladewright

# BLADEWRIGHT_SHORT=1 mills ridges three times as high, as CI does.
# Every command that README and manual print, run as printed
manual:
    cargo nextest run --release --run-ignored only -E 'test(/^manual::/)'

# Published blades are planned too where BLADEWRIGHT_BLADES names their folder.
# Examples planned by two builds: the same bytes
same old new:
    bash tests/same/run.sh {{old}} {{new}}
