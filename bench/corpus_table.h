// Rows as Markdown and as JSON.  Role: the output of bench/corpus.
#pragma once

#include <string>
#include <vector>

#include "corpus_run.h"

namespace hgp::bench {

/// Header of the Markdown table, one row of it, and the sums below it.
std::string tableHead();
std::string tableRow(const CorpusRow& row);
std::string totals(const std::vector<CorpusRow>& rows);

std::string toJson(const std::vector<CorpusRow>& rows, const CorpusOptions& options);

/// One row as a line of JSON, and back.
std::string toJson(const CorpusRow& row);
CorpusRow rowFromJson(const std::string& text);

}  // namespace hgp::bench
