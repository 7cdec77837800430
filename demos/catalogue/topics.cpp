#include "topics.h"

#include <algorithm>
#include <cctype>

namespace plait {

std::string folderOf(TopicSort sort) {
    return sort == TopicSort::constraint ? "constraints"
           : sort == TopicSort::method   ? "methods"
                                         : "forces";
}

std::span<const Topic> topics() {
    static const std::vector<Topic> all = [] {
        std::vector<Topic> list = constraintTopics();
        for (std::vector<Topic> more : {setTopics(), methodTopics(), forceTopics()})
            list.insert(list.end(), more.begin(), more.end());
        return list;
    }();
    return all;
}

namespace {

// A name of C++ that no longer name ends with.
bool hasMark(const std::string& type, const std::string& mark) {
    const std::size_t at = type.find(mark);
    return at != std::string::npos &&
           (at == 0 || !std::isalnum(static_cast<unsigned char>(type[at - 1])));
}

}  // namespace

std::vector<const Topic*> topicsOfType(const std::string& type) {
    std::vector<const Topic*> found;
    for (const Topic& topic : topics())
        if (topic.sort == TopicSort::constraint &&
            std::ranges::any_of(topic.marks,
                                [&](const std::string& mark) { return hasMark(type, mark); }))
            found.push_back(&topic);
    return found;
}

const Topic* topicOf(TopicSort sort, const std::string& mark) {
    for (const Topic& topic : topics())
        if (topic.sort == sort && std::ranges::count(topic.marks, mark) > 0) return &topic;
    return nullptr;
}

}  // namespace plait
