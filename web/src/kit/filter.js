// The filter of a table: a word, or a condition such as  mass_g < 20 && outcome == "made".
const kToken = /"[^"]*"|[A-Za-z_]\w*|-?\d+(?:\.\d+)?(?:e[-+]?\d+)?|<=|>=|==|!=|&&|\|\||[<>()]/gi;
const kCompare = {
  "<": (x, y) => x < y, ">": (x, y) => x > y, "<=": (x, y) => x <= y, ">=": (x, y) => x >= y, "==": (x, y) => x === y, "!=": (x, y) => x !== y,
};

/**
 * A condition as a function of a row. It is compiled by hand, so that the page runs no text as code. An unknown value fulfils no comparison.
 * @param columnOf the function of a row that gives a column's value, or undefined for an unknown name
 * @throws a text that says what is wrong
 */
export function condition(source, columnOf) {
  const tokens = source.match(kToken) ?? [];
  let at = 0;
  const value = () => {
    const token = tokens[at++];
    if (token === undefined) throw "the condition ends too early";
    if (token === "(") {
      const inner = either();
      if (tokens[at++] !== ")") throw "a bracket is not closed";
      return inner;
    }
    if (token[0] === '"') return () => token.slice(1, -1);
    if (/^-?\d/.test(token)) return () => Number(token);
    const column = columnOf(token);
    if (!column) throw `there is no column ${token}`;
    return column;
  };
  const compared = () => {
    const left = value(), holds = kCompare[tokens[at]];
    if (!holds) return left;
    ++at;
    const right = value();
    return (row) => {
      const x = left(row), y = right(row);
      return x !== null && y !== null && holds(x, y);
    };
  };
  const joined = (sign, next, join) => () => {
    let all = next();
    while (tokens[at] === sign) {
      ++at;
      const left = all, right = next();
      all = join(left, right);
    }
    return all;
  };
  const both = joined("&&", compared, (left, right) => (row) => left(row) && right(row));
  const either = joined("||", both, (left, right) => (row) => left(row) || right(row));
  const result = either();
  if (at < tokens.length) throw `not understood: ${tokens[at]}`;
  return result;
}

/** The rows that a filter keeps. @param textsOf the texts of a row, for a word @throws as condition */
export function filtered(rows, source, columnOf, textsOf) {
  const filter = source.trim();
  if (!filter) return rows;
  if (/[<>=!]/.test(filter)) return rows.filter(condition(filter, columnOf));
  const word = filter.toLowerCase();
  return rows.filter((row) => textsOf(row).some((text) => text.toLowerCase().includes(word)));
}
