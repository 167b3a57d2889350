// What each code means and how to mend it.
#include "scree/input/codes.h"

namespace scree {
namespace {

constexpr ErrorCode codes[] = {
    {"E100", "the case file cannot be read",
     "The file does not exist, is a directory, is larger than 256 MiB, or may not be read by you. Check its name and "
     "permissions."},
    {"E101", "syntax",
     "The file is not TOML. Usual causes: a text or a number with a unit without quotes, a bracket that is not closed, "
     "a "
     "key or table written twice. Only the first such error can be shown."},
    {"E102", "unknown key or table",
     "Nothing of that name exists here; names that are not known are never ignored, because a mistyped key would "
     "silently leave its default. The message suggests the key that was probably meant, or the table where it "
     "belongs."},
    {"E103", "missing key", "A key without a default is not given. The message says what its value must be."},
    {"E104", "wrong kind of value", "A text stands where a number is expected, a number instead of a list, and so on."},
    {"E105", "wrong number of elements", "A list has too few or too many elements: vectors have three."},
    {"E110", "not a choice", "The key takes one of a few words. The message lists them."},
    {"E112", "not a name",
     "Names begin with a letter and go on with letters, digits, _ or -, so that they can stand in key paths such as "
     "materials.glass.friction."},
    {"E120", "wrong unit",
     "The unit measures something else than the key: a length in place of a pressure, say. An angle is a dimension of "
     "its own here: an angular velocity is given in rad/s, deg/s or rpm, not in Hz."},
    {"E121", "not a quantity", "A text with a unit is a number followed by a unit, as in \"1.2 mm\" or \"2.5 g/cm3\"."},
    {"E122", "missing unit", "A number in quotes must have a unit. Without quotes it is in SI units."},
    {"E130", "out of range", "The number is outside the limits of its key."},
    {"E131", "not finite", "Infinities and NaN are no values of a case."},
    {"E132", "too many steps",
     "The end of the run divided by its time step is more than 2^53, about 9e15: beyond it the time of a step cannot "
     "be "
     "told from that of the next, and no machine gets there. Usually a unit is missing: an end in seconds where "
     "\"1 ms\" was meant, or a time step of picoseconds."},
    {"E133", "more particles than the memory holds",
     "The particles that the case begins with need more memory than is available on this machine, even without their "
     "contacts. `scree check` tells what a case needs in all."},
    {"E140", "not a formula",
     "The text could not be compiled as a formula. `scree explain formulas` says what formulas can contain."},
    {"E150", "key without effect",
     "The key is read only when another key has a certain value. It is refused, not ignored, because whoever wrote it "
     "expects it to act. On the command line the other key may be switched off nevertheless."},
    {"E160", "unknown reference", "A material, a variant or a particle that the case does not have is referred to."},
    {"E161", "duplicate", "Two things of one kind have the same name."},
    {"E163", "something needed is missing", "A chosen law or flow needs a property that is not given."},
    {"E164", "choices that do not fit together",
     "Two choices exclude each other, or a property is given that no chosen law reads."},
    {"E165", "impossible geometry",
     "The domain, a wall or a region is empty, flat or reversed, or particles would be put outside the domain."},
    {"E166", "periodic box too small",
     "A periodic axis must be longer than twice the distance over which two particles can act on each other; else a "
     "particle would meet another one from both sides."},
    {"E167", "values that contradict each other", "Two values, each possible, cannot both be meant."},
    {"E168", "file not found", "A file that the case names does not exist. File names are relative to the case file."},
    {"E169", "how many particles", "The number of particles is not given, or in two ways."},
    {"E170", "unusable expectation", "An expectation says nothing, or contradicts itself."},
    {"E171", "a field that breaks the period",
     "What leaves through one face of a periodic axis comes in through the other. A flow or a body force must "
     "therefore "
     "be the same at both faces: a shear flow cannot cross a periodic y axis, Taylor-Green vortices must fit a whole "
     "number of times, a rotating frame can be periodic along its axis only, and an attracting point allows no "
     "periodic axis. `scree check` looks at formulas."},
    {"E172", "unusable mesh",
     "The file of a mesh is there but is no STL or OBJ file, or is cut short, or holds no triangle that has an area. "
     "The "
     "message names the line or byte. Export the surface again, as STL (text or binary) or as OBJ."},
    {"E173", "impossible motion of a wall",
     "The axis of a rotation has no direction, a motion ends before it begins, or a formula is none, is no finite "
     "number "
     "at some time of the run, or does not begin at 0: walls are at their place when their motion starts. A surface "
     "velocity lies in its wall."},
    {"E174", "particles of another run that cannot be taken",
     "The checkpoint that particles.checkpoint names is missing, damaged, no checkpoint, or holds no particle that can "
     "be "
     "taken over. It may be a checkpoint file or the directory of a run."},
    {"E180", "override that leads nowhere",
     "The path given to --set, or in a variant, does not lead to a key. Tables in lists are found by their name or by "
     "their index from 0: materials.glass.restitution=0.5, particles.0.velocity.value=[1, 0, 0]."},
    {"E181", "variant that is no valid case", "With the keys that the variant sets, the case has an error."},
    {"E190", "unusable command line",
     "A command or an option that Scree does not have, or one without its value. `scree --help` lists the commands, "
     "`scree run --help` the options of one."},
    {"E192", "no flow solver in this program",
     "The program was built without MPI or without hypre, which solve for the pressure of a fluid. Install "
     "libhypre-dev "
     "and "
     "an MPI, and build with -DSCREE_MPI=ON."},
    {"E193", "not there yet on devices",
     "The case needs something that runs on the CPU only so far. Run it without --device."},
};

}  // namespace

std::span<const ErrorCode> error_codes() { return codes; }

}  // namespace scree
