#include "assembly/bill.h"

#include <fmt/format.h>

#include <algorithm>

#include "fusee/assembly/assembly.h"
#include "fusee/core/csv.h"
#include "fusee/report/assembly.h"

namespace fusee::report {

namespace {

constexpr const char* kSheet = "_inspection.csv";

/// Parts that fusee makes name the sheet by which they are inspected.
std::vector<assembly::BillRow> rows_of(const pipeline::DesignReport& design) {
    const std::vector<std::string> sheets = inspection_sheets(design);
    std::vector<assembly::BillRow> rows = assembly::bill_of(*design.assembly);
    for (assembly::BillRow& row : rows)
        if (std::find(sheets.begin(), sheets.end(), row.item + kSheet) != sheets.end())
            row.note += fmt::format("; inspected with {}{}", row.item, kSheet);
    return rows;
}

}  // namespace

std::vector<std::string> inspection_sheets(const pipeline::DesignReport& design) {
    std::vector<std::string> names;
    for (const pipeline::PartReport* part : design.sides())
        for (const pipeline::FileRow& row : part->files)
            if (row.entry.name.ends_with(kSheet)) names.push_back(row.entry.name);
    return names;
}

std::string bill_csv(const pipeline::DesignReport& design) {
    std::string csv = "item,count,size,note\n";
    for (const assembly::BillRow& row : rows_of(design))
        csv += fmt::format("{},{},{},{}\n", core::csv_cell(row.item), row.count, core::csv_cell(row.size), core::csv_cell(row.note));
    return csv;
}

std::string bill_table(const pipeline::DesignReport& design) {
    std::string table = "\n## Bill of materials\n| item | count | size | note |\n|---|---|---|---|\n";
    for (const assembly::BillRow& row : rows_of(design))
        table += fmt::format("| {} | {} | {} | {} |\n", row.item, row.count, row.size, row.note);
    return table;
}

}  // namespace fusee::report
