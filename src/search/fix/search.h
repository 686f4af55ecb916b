#pragma once
#include <limits>
#include <memory>
#include <queue>
#include <set>
#include <vector>

#include "draft.h"
#include "judge.h"
#include "scan.h"

namespace fusee::search::fix {

/// A possible change against a finding. The search judges whether it helps.
struct Move {
    core::Changes changes;
    Follows follows;
    core::Finding because;
    int left = 0;  ///< findings expected afterwards: of a suggestion at best, of a scan as judged
};

/// The changes that the finding suggests, in its order, except changes of facts, of sizes that are not on sale and of parts that are not
/// known to be strong enough. A base spring that was already changed for its cam is not changed for it again.
/// @param finding of `verdict` @param draft the profile with `choices` @param refused by key: why its change was refused; the first
/// reason stays
[[nodiscard]] std::vector<Move> suggested(const core::Finding& finding, const Verdict& verdict, const profile::Profile& draft,
                                          const Choices& choices, const Drafts& drafts, std::map<std::string, std::string>& refused);

/// Base springs and laws that a scan finds, if law and cams do not fit each other.
[[nodiscard]] std::vector<Move> scanned(const Verdict& verdict, const profile::Profile& draft, const Choices& choices, Scan& scan);

/// The result of the search for a profile that can be made.
struct Searched {
    bool found = false;   ///< made with every file
    std::string ended;    ///< why the search ended before it had tried every change; empty: it has
    Choices choices;      ///< of the profile found, or of the nearest one
    core::Findings left;  ///< findings against the nearest
    std::set<std::string> circles;
    std::vector<Conflict> conflicts;             ///< of the findings left
    std::map<std::string, std::string> refused;  ///< by key: why a suggested change was not made
};

/// Best-first search: the draft with the least cost of its choices plus the estimated cost of its findings is next. Drafts are judged when
/// it is their turn, so that most expensive ones are never judged. One thread, no random number: the same profile gives the same result.
class Search {
public:
    Search(const Drafts& drafts, Judge& judge, const FixOptions& options)
        : drafts_(drafts), judge_(judge), scan_(drafts, judge, options.jobs), options_(options) {}
    [[nodiscard]] Searched run();

private:
    struct Node {
        Choices choices;
        double cost = 0.0;
        std::shared_ptr<const Node> parent;
        std::optional<Verdict> verdict = {};  ///< none: not judged yet
        bool followed = false;                ///< its suggestions were followed: a scan is next
    };
    using NodePtr = std::shared_ptr<Node>;
    struct Ranked {
        double rank;
        int sequence;  ///< of equals the earlier
        NodePtr node;
        bool operator<(const Ranked& other) const { return rank != other.rank ? rank > other.rank : sequence > other.sequence; }
    };

    void push(const NodePtr& node, int left);
    void add(const NodePtr& parent, Choices choices, int left);
    void look(const NodePtr& node);
    void follow(const NodePtr& node);
    void expand(const NodePtr& node);
    [[nodiscard]] Choices moved(const Choices& from, const Move& move);
    [[nodiscard]] bool makes(const NodePtr& node);
    void keep_nearest(const Node& node, bool made);
    void note_circle(const Node& node);
    void note_conflicts(const Node& node);
    void keep_conflicts();

    const Drafts& drafts_;
    Judge& judge_;
    Scan scan_;
    const FixOptions& options_;
    std::priority_queue<Ranked> queue_;
    std::set<std::string> seen_;
    int sequence_ = 0, moves_ = 0;
    double least_left_ = std::numeric_limits<double>::infinity();
    std::map<std::pair<std::string, std::string>, Conflict> broken_by_;  ///< by the names of the cured and the broken finding
    Searched result_;
};

}  // namespace fusee::search::fix
