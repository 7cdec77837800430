#include "facts.h"

#include <cxxabi.h>
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <typeinfo>

namespace plait {
namespace {

// "plait::ConstraintSet<plait::Stretch, double>".
std::string typeNameOf(const std::type_info& type) {
    int status = 0;
    const std::unique_ptr<char, void (*)(void*)> name(
        abi::__cxa_demangle(type.name(), nullptr, nullptr, &status), std::free);
    return status == 0 ? name.get() : type.name();
}

std::vector<ScheduledSet> scheduledOf(const World& world) {
    std::vector<ScheduledSet> sets;
    for (const World::Set& set : world.sets)
        sets.push_back({.name = set.options.name,
                        .order = set.options.order,
                        .importance = set.options.importance,
                        .contact = set.contact,
                        .secondaryInterval = set.options.secondaryInterval});
    return sets;
}

void addSchedule(SceneFacts& facts, const Run& run) {
    const World& world = run.scene.world;
    const Schedule schedule(scheduledOf(world), run.scene.options.schedule);
    SubstepPlan plan, later;
    schedule.plan(0, plan);
    for (int substep = 1; substep < std::min(60, facts.substeps * 4); ++substep) {
        schedule.plan(substep, later);
        facts.even = facts.even && later.counts == plan.counts;
    }
    for (const int s : schedule.order()) {
        const World::Set& set = world.sets[static_cast<std::size_t>(s)];
        const auto made = set.recipe.make<double>(world, run.scene.options.kernels);
        const Constraint<double>& constraint = *made;
        facts.sets.push_back({.name = set.options.name,
                              .topics = topicsOfType(typeNameOf(typeid(constraint))),
                              .constraints = constraint.size(),
                              .contact = set.contact,
                              .evaluations = plan.counts[static_cast<std::size_t>(s)]});
    }
    const int most = std::max(1, std::min(26 / static_cast<int>(plan.columns.size()), 8));
    for (int substep = 0; substep < std::min(facts.substeps, most); ++substep) {
        schedule.plan(substep, plan);
        for (const SubstepPlan::Column& column : plan.columns) {
            ColumnFacts& here = facts.columns.emplace_back(substep, std::vector<bool>{});
            for (const int s : schedule.order())
                here.runs.push_back(std::ranges::count(plan.constraints(column), s) +
                                        std::ranges::count(plan.contacts(column), s) >
                                    0);
        }
    }
}

void addForces(SceneFacts& facts, const Run& run) {
    for (const Recipe<Force>& force : run.scene.world.forces) {
        const std::string name =
            force.make<double>(run.scene.world, run.scene.options.kernels)->name();
        if (std::ranges::count(facts.forces, name) == 0) facts.forces.push_back(name);
    }
}

void addEffects(SceneFacts& facts, const Run& run) {
    const auto has = [&](const std::string& topic) {
        return std::ranges::any_of(facts.sets, [&](const SetFacts& set) {
            return std::ranges::any_of(set.topics,
                                       [&](const Topic* t) { return t->name == topic; });
        });
    };
    const bool liquid = has("density"), rubber = has("membrane"),
               rigid = has("pieces") || has("welds");
    const bool sheet = has("bend") || has("shear") || has("strands") || has("aggregates");
    const bool curves = has("rod") || has("chain") || has("angle") ||
                        (!sheet && !liquid && !rubber && !rigid && has("stretch"));
    const std::vector<bool> is{sheet && !rubber,
                               curves,
                               rubber,
                               liquid,
                               rigid,
                               has("welds"),
                               std::ranges::count(facts.forces, "air") > 0,
                               std::ranges::any_of(facts.sets, &SetFacts::contact),
                               run.scene.options.schedule.substeps > 0 && facts.vertices <= 3};
    for (std::size_t e = 0; e < is.size(); ++e)
        if (is[e]) facts.effects.push_back(allEffects()[e]);
}

}  // namespace

const std::vector<std::string>& allEffects() {
    static const std::vector<std::string> names{"cloth",        "ropes and wires", "rubber and gas",
                                                "liquid",       "rigid pieces",    "breaking",
                                                "air and wind", "contact",         "first lessons"};
    return names;
}

std::vector<const Topic*> SceneFacts::topics() const {
    std::vector<const Topic*> all;
    const auto add = [&](const Topic* topic) {
        if (topic && std::ranges::count(all, topic) == 0) all.push_back(topic);
    };
    for (const SetFacts& set : sets)
        for (const Topic* topic : set.topics) add(topic);
    for (const std::string& force : forces) add(topicOf(TopicSort::force, force));
    add(topicOf(TopicSort::method, method()));
    return all;
}

SceneFacts factsOf(const SceneEntry& entry, const std::string& quality) {
    const Run run = makeRun({{"scene", entry.name}, {"quality", quality}});
    const World& world = run.scene.world;
    const SolverOptions& options = run.scene.options;
    SceneFacts facts{.entry = &entry,
                     .quality = quality,
                     .settings = settingsOf(run),
                     .metrics = run.scene.metrics,
                     .closedForms = run.scene.facts,
                     .sets = {},
                     .columns = {},
                     .forces = {},
                     .effects = {}};
    facts.vertices = world.complex.count(0), facts.edges = world.complex.count(1);
    facts.triangles = world.complex.count(2), facts.tetrahedra = world.complex.count(3);
    facts.pinned = static_cast<int>(std::ranges::count(world.pinned, 1));
    facts.substeps = options.schedule.substeps;
    facts.framesASecond = run.frameRate();
    facts.seconds = run.scene.seconds;
    facts.palindrome = options.sweeps == Sweeps::palindrome;
    facts.interleaved = options.schedule.mode == ScheduleMode::interleaved;
    addSchedule(facts, run);
    addForces(facts, run);
    addEffects(facts, run);
    return facts;
}

}  // namespace plait
