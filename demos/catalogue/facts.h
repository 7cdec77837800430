// What a scene is made of, read off its world: so it says what runs, and nothing is written twice.
#pragma once

#include "demos/runs/settings.h"
#include "topics.h"

#include <plait/schedule.h>

#include <string>
#include <vector>

namespace plait {

// A set of constraints as it takes part in a substep.
struct SetFacts {
    std::string name;
    std::vector<const Topic*> topics;
    long constraints = 0;  // 0: as many as meet
    bool contact = false;
    int evaluations = 0;  // in the first substep
};

// A column of the schedule, and which sets run in it.
struct ColumnFacts {
    int substep = 0;  // from 0 on
    std::vector<bool> runs;
};

struct SceneFacts {
    const SceneEntry* entry = nullptr;
    std::string quality;
    Settings settings;
    std::vector<Metric> metrics;
    std::vector<std::string> closedForms;  // Scene::facts
    std::vector<SetFacts> sets;            // in the order of a column
    std::vector<ColumnFacts> columns;      // of the first few substeps
    std::vector<std::string> forces;       // their names
    std::vector<std::string> effects;      // "cloth", "liquid", ...: of what sort its matter is
    int vertices = 0, edges = 0, triangles = 0, tetrahedra = 0, pinned = 0;
    int substeps = 0;
    double framesASecond = 0, seconds = 0;
    bool palindrome = false, interleaved = true, even = true;  // even: all substeps are alike

    std::string method() const { return valueOf(settings, "method"); }
    // Constraints, forces and the method of it.
    std::vector<const Topic*> topics() const;
};

// Of the scene with its defaults. Throws as makeRun() does.
SceneFacts factsOf(const SceneEntry& entry, const std::string& quality);

// The effects that a scene may have, in one order.
const std::vector<std::string>& allEffects();

}  // namespace plait
