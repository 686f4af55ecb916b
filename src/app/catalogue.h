#pragma once
#include <array>

namespace fusee::app {

/// Groups of the help, in its order.
inline constexpr const char *kMakeGroup = "Make a part", *kTestGroup = "Test a joint", *kLookUpGroup = "Look up";

/// A command as the help of every program lists it.
struct CommandInfo {
    const char* name;
    const char* group;  ///< "": the help does not list it
    const char* description;
};

/// All commands in the order of the help. A program may hold a part of them (program.h).
inline constexpr std::array kCommands{
    CommandInfo{"init", kMakeGroup,
                "Write a first profile from a few answers: questions on a terminal, options in a script; fusee make accepts it"},
    CommandInfo{"make", kMakeGroup, "Make checked cams from profiles: out/NAME with STL, 3MF, DXF, SCAD, PART.json and a report"},
    CommandInfo{"watch", kMakeGroup,
                "Remake a profile on each save: first the verdict in milliseconds, then all files; with --serve the page reloads itself"},
    CommandInfo{"check", kMakeGroup, "Check the cams of a profile, or a third-party mesh, against every rule; without exported files"},
    CommandInfo{"fix", kMakeGroup, "Change a profile until it can be made: a new profile that states each change and its reason"},
    CommandInfo{"batch", kMakeGroup, "Make every design of a study, with an index of their figures; goes on where it was stopped"},
    CommandInfo{"query", kMakeGroup, "Ask the index of a study in SQL, read-only; prints columns separated by tabs"},
    CommandInfo{"design", kMakeGroup, "Find springs for the joint of a profile: out/NAME-design with the new law as a profile"},
    CommandInfo{"springs", kMakeGroup, "Turn the wanted rates into springs that can be wound or bought: a new profile with their data"},
    CommandInfo{"budget", kMakeGroup,
                "State the errors of joints as a shop builds them: torque and dead-band by source, and the tolerances for a wanted band"},
    CommandInfo{"render", kMakeGroup, "Draw the cams, the joint, a curve or a gap map as a picture, PNG or SVG"},
    CommandInfo{"coupons", kMakeGroup,
                "Make test pieces for the machine and the cable of a profile: out/NAME-coupons with plate, groove ladder, disc and a sheet "
                "to fill in"},
    CommandInfo{"calibrate", kMakeGroup,
                "Compute the compensation of a profile from measured coupons: shrinkage, bore offset, neutral axis of the cable, spring "
                "rates; or from the inspection sheet of a finished part: offset, eccentricity and rotation of its contour"},
    CommandInfo{"simulate", kTestGroup,
                "Simulate the joints of profiles: out/NAME with dead_band.csv, simulation.json and a page of figures"},
    CommandInfo{"case-template", kTestGroup,
                "Write an empty gap case for the joint of a profile: nominal rig, set points and sheets to fill in during the tests"},
    CommandInfo{"identify", kTestGroup,
                "Identify the friction of a gear from break-away tests: out/identify-FILE with identification.json and a page like figure "
                "8 of the paper"},
    CommandInfo{"diagnose", kTestGroup,
                "Diagnose a built joint: where it and its model diverge, which effect causes it, and how much of the gap remains"},
    CommandInfo{"predict", kTestGroup,
                "Predict the measurements of a gap case for other inputs, with or without the effects of a diagnosis"},
    CommandInfo{"blind", kTestGroup, "Benchmark the diagnosis on sealed cases"},
    CommandInfo{"paper", kTestGroup, "Reproduce every table and figure of the paper: out/paper with paper.html and a CSV file for each"},
    CommandInfo{"explain", kLookUpGroup, "Explain a rule, a key of a profile, an effect of the diagnosis, or a term"},
    CommandInfo{"keys", kLookUpGroup, "List the keys of a profile with unit, allowed values and default"},
    CommandInfo{"rules", kLookUpGroup, "List the rules with their limits and sources"},
    CommandInfo{"completion", "", "Print the completion script of a shell"},
    CommandInfo{"man", "", "Print the manual page"},
};

}  // namespace fusee::app
