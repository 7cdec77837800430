// What scenes are made of, each with a page: constraints, methods, forces. Equations are here and
// nowhere else; what a header says of itself is read from the header.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace plait {

enum class TopicSort { constraint, method, force };

// A formula and the sentence that says what its letters are.
struct Equation {
    std::string tex;    // as mathMl() takes it
    std::string words;  // formulas between $ signs
};

struct Topic {
    TopicSort sort;
    std::string name;  // of its page, and of the filter
    std::string title;
    // By which a set is known for one: parts of the name of its type, "Bend," or "ContactSet<";
    // of a method the word of --method; of a force its name.
    std::vector<std::string> marks;
    std::string header;  // where it is written, from the root of the sources
    std::string lesson;  // one sentence for who never saw it
    std::vector<Equation> equations;
    std::vector<std::string> rows = {};  // of the seeds
    std::vector<std::string> maps = {};  // of stability, where it is seen to fail
};

// "constraints", "methods", "forces": the folder of their pages.
std::string folderOf(TopicSort sort);

// All of them, by sort, in the order in which one would teach them.
std::span<const Topic> topics();
std::vector<Topic> constraintTopics();
std::vector<Topic> setTopics();  // constraints too: those that are solved at once, and contacts
std::vector<Topic> methodTopics();
std::vector<Topic> forceTopics();

// Those that a set whose type has this name is made of.
std::vector<const Topic*> topicsOfType(const std::string& type);
// nullptr where there is none.
const Topic* topicOf(TopicSort sort, const std::string& mark);

}  // namespace plait
