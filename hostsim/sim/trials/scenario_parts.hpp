// SPDX-License-Identifier: MIT
//
// The parts of a scenario file that every kind of scenario has.
#ifndef OCELLUS_SIM_SCENARIO_PARTS_HPP
#define OCELLUS_SIM_SCENARIO_PARTS_HPP

#include "support/toml_reader.hpp"
#include "trials/scenario.hpp"

namespace sim {

// All throw cli::InputError with file, line, column and what was expected.
toml::table parse_scenario_file(const std::string &path);
void read_camera(TomlReader reader, CameraChoice &camera);
void read_target(TomlReader reader, TargetChoice &target);
void read_scene(TomlReader reader, Setting &setting);

// Of [detector] the keys `colour` and `min_area`; the caller reads the others.
void read_search(TomlReader &reader, Setting &setting);

} // namespace sim

#endif
