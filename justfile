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

# Mutated models and programs against every reader: seconds (600) or executions (1000000x) for each of the formats (all, models, programs, or names)
fuzz length="600" formats="all":
    cargo run --release --example fuzz_readers -- {{length}} {{formats}}

# Bull-nose and flat cutters on triangles beside OpenCAMLib: Python (PYTHON=...) with `pip install opencamlib`
opencamlib places="2000":
    cargo build --release --example drop_cutter
    "${PYTHON:-python3}" tests/opencamlib/compare.py target/release/examples/drop_cutter {{places}}

# Closest points, inside, area and volume beside OpenCASCADE: Python (PYTHON=...) with `pip install cadquery-ocp numpy`
occ points="10000" *models="models/steam_root.step models/compressor_twist.step models/turbine_camber.step models/prism.step":
    cargo build --release --examples --bins
    "${PYTHON:-python3}" tests/occ/compare.py target/release {{points}} {{models}}

# The same where its search over all faces takes too long: its local search from many starts
occ-dense points="10000" *models="models/steam_root.step":
    cargo build --release --examples --bins
    "${PYTHON:-python3}" tests/occ/dense.py target/release {{points}} {{models}}

# Every kind of face, file and unit of STEP and IGES as OpenCASCADE writes them: closed, with its area and volume
occ-entities:
    cargo build --release --bins
    "${PYTHON:-python3}" tests/occ/entities.py target/release

# Loading time beside OpenCASCADE; models may be meshes (STL, OBJ), MODEL@m is one in metres whatever it says
occ-load *models="models/steam_root.step models/compressor_twist.step models/turbine_camber.step models/prism.step":
    cargo build --release --examples
    "${PYTHON:-python3}" tests/occ/load.py target/release {{models}}

# Free angles against brute force and parry3d: tens of thousands of random tools, parts and moves
brute times="50":
    BLADEWRIGHT_CASES={{times}} cargo nextest run --release --lib channel::tests::brute

# Motions of the project's blades under three sets of limits, differentiated by code that did not plan them: Python 3.11
motion:
    cargo build --release
    bash tests/motion/run.sh target/release/bladewright

# The channel of 100 000 locations beside generic collision tests
bench-channel:
    cargo bench --bench channel

# Programs of the examples read by LinuxCNC's interpreter (apt) and nc-gcode-interpreter (PyPI), kinematics beside LinuxCNC's
controls:
    cargo build --release --bins --example axis_positions
    bash tests/controls/run.sh target/release/bladewright target/release/examples/axis_positions

# The feed beside toppra and copp, and seconds for 100 000 locations: Python (PYTHON=...) with `pip install numpy scipy toppra copp-py`
bench-feed locations="2000":
    BLADEWRIGHT_PEERS="${PYTHON:-python3} tests/motion/peers.py" cargo bench --bench feed -- --locations={{locations}}

# Closest points a second, beside parry's query to the triangles
bench:
    cargo bench --bench closest

# report.html and preview.glb of every example and a family's page in headless Chromium, and Khronos' validator: Node 20, chromium
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

# A family as an array job on a real Slurm on this machine: needs root and `apt-get install slurmctld slurmd slurm-client munge`
slurm:
    cargo build --release
    bash tests/slurm/run.sh target/release/bladewright

# The Kubernetes Jobs' schemas and commands, without a cluster: Python (PYTHON=...) with `pip install kubernetes-validate pyyaml`
kubernetes:
    cargo build --release
    bash tests/kubernetes/run.sh target/release/bladewright

# A family on S3-compatible storage on this machine: Python (PYTHON=...) with `pip install "moto[server]" boto3`
s3:
    cargo build --release --features s3
    bash tests/s3/run.sh target/release/bladewright

# Every command that README and manual print, run as printed; BLADEWRIGHT_SHORT=1 mills ridges three times as high, as CI does
manual:
    cargo nextest run --release --run-ignored only -E 'test(/^manual::/)'

# Examples and, where BLADEWRIGHT_BLADES names their folder, published blades planned by two builds: the same bytes
same old new:
    bash tests/same/run.sh {{old}} {{new}}
