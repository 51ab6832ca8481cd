/* The one C++ file.  Two models, control points alone and everything, go through one descent: L-BFGS of Ceres in coordinates in which the
 * weighted least-squares matrix of the moment is the unit matrix, the smoothing taken back stage by stage. */
#include "etalon/refine/ceres.h"
#include "etalon/base/real.h"
#include "etalon/spline/basis.h"
#include "etalon/spline/knots.h"
#include <Eigen/Sparse>
#include <algorithm>
#include <ceres/ceres.h>
#include <climits>
#include <cmath>
#include <glog/logging.h>
#include <limits>
#include <new>
#include <stdexcept>
#include <vector>

namespace
{

using Matrix = Eigen::SparseMatrix<double>;
using Points = Eigen::MatrixX3d;          /* a row a control class; columns x, y, z */
using Entry = Eigen::Triplet<double>;
using Eigen::Index;
using Eigen::VectorXd;

/* The messages of glog below FATAL are held back while this lives. */
class Silence
{
public:
    Silence() : before(FLAGS_minloglevel)
    {
        FLAGS_minloglevel = google::GLOG_FATAL;
    }
    ~Silence()
    {
        FLAGS_minloglevel = before;
    }
    Silence(const Silence &) = delete;
    Silence &operator=(const Silence &) = delete;

private:
    int before;
};

/* A positive definite sparse matrix A = L L' (rows and columns in an order that keeps L sparse) as a change of coordinates. */
class Metric
{
public:
    /* damping: relative to the greatest diagonal entry, added to all: what the data leave free must not be moved freely. */
    void set(Matrix A, double damping)
    {
        double most = 0;

        for (Index k = 0; k < A.rows(); k++)
            most = std::max(most, A.coeff(k, k));
        if (!std::isfinite(A.sum()))
            throw std::range_error("metric");
        for (double ridge = most > 0 ? most * damping : 1;; ridge *= 16) {
            for (Index k = 0; k < A.rows(); k++)
                A.coeffRef(k, k) += ridge;
            llt.compute(A);
            if (llt.info() == Eigen::Success)
                return;
        }
    }
    /* x = L'^-1 y: a step from the coordinates of the solver to our own. */
    template <class T> void to_own(T &x) const
    {
        llt.matrixU().solveInPlace(x);
        x = (llt.permutationPinv() * x).eval();
    }
    /* g = L^-1 g: a gradient from our own coordinates to the solver's. */
    template <class T> void to_solver(T &g) const
    {
        g = (llt.permutationP() * g).eval();
        llt.matrixL().solveInPlace(g);
    }

private:
    Eigen::SimplicialLLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<int>> llt;
};

Points matrix_of(const et_vec3 *points, size_t n)
{
    Points m((Index)n, 3);

    for (size_t k = 0; k < n; k++)
        m.row((Index)k) << points[k].x, points[k].y, points[k].z;
    return m;
}

std::vector<et_vec3> vectors_of(const Points &m)
{
    std::vector<et_vec3> points((size_t)m.rows());

    for (size_t k = 0; k < points.size(); k++)
        points[k] = {m((Index)k, 0), m((Index)k, 1), m((Index)k, 2)};
    return points;
}

/* What the descent needs of a model: a smoothed objective in the solver's coordinates, 0 being where center() was last called. */
class Model
{
public:
    virtual ~Model() = default;
    virtual int size() const = 0;
    /* Data classes; iterations of L-BFGS between two changes of the metric (found by trial, flat within a factor of two). */
    virtual double classes() const = 0;
    virtual int inner() const = 0;
    /* Take y as the new origin, with the metric that belongs to mu there. */
    virtual void center(const double *y, double mu) = 0;
    /* sum sqrt(|r|^2 + mu^2) and, if gradient is not null, its gradient; keeps the best by the sum of |r|. */
    virtual bool evaluate(const double *y, double mu, double *cost, double *gradient) = 0;
    double best = std::numeric_limits<double>::infinity();
    size_t evaluations = 0;
};

/* The basis functions that are not zero at t: value[k] and, k + p + 1, their slopes; `first` is the control point of the first. */
struct Basis {
    size_t first = 0;
    std::vector<double> value, work;

    void set(const double *knots, size_t nu, size_t p, double t)
    {
        const size_t span = et_knots_span(knots, nu, p, t);

        value.resize(2 * (p + 1));
        work.resize(et_basis_work(p, 1));
        et_basis_ders(value.data(), 1, knots, nu, p, span, t, work.data(), work.size());
        first = span - p;
    }
};

/* Points: the residual is linear, r_c = D_c - sum_k a_ck P_k. */
class PointsModel : public Model
{
public:
    PointsModel(const et_fit *fit, const et_vec3 *data);
    int size() const override
    {
        return (int)(3 * x.rows());
    }
    double classes() const override
    {
        return (double)d.rows();
    }
    int inner() const override
    {
        return 16;
    }
    void center(const double *y, double mu) override;
    bool evaluate(const double *y, double mu, double *cost, double *gradient) override;
    Points best_points;

private:
    void add_class(const et_fit *fit, size_t view, size_t i, size_t j);
    Eigen::Map<const Points> shift(const double *y) const
    {
        return Eigen::Map<const Points>(y, x.rows(), 3);
    }

    Eigen::SparseMatrix<double, Eigen::RowMajor> a;
    std::vector<Entry> entries;
    Basis bu, bv;
    Points x, d, r;
    Metric metric;
};

PointsModel::PointsModel(const et_fit *fit, const et_vec3 *data)
{
    const et_doublenet net = fit->data, control = et_shell_net(&fit->shell);
    const size_t nov = et_doublenet_nov(net), n = et_doublenet_nov(control);
    std::vector<et_vec3> start(n);

    et_shell_gather(start.data(), n, &fit->shell);
    for (size_t view = ET_BOTTOM; view <= ET_TOP; view++)
        for (size_t i = 0; i < net.nx; i++)
            for (size_t j = 0; j < net.ny; j++)
                if (view == ET_BOTTOM || et_doublenet_class(net, view, i, j) > net.nx * net.ny)
                    add_class(fit, view, i, j);
    a.resize((Index)nov, (Index)n);
    a.setFromTriplets(entries.begin(), entries.end());
    x = matrix_of(start.data(), n);
    d = matrix_of(data, nov);
    best_points = x;
}

void PointsModel::add_class(const et_fit *fit, size_t view, size_t i, size_t j)
{
    const et_surface *const s = &fit->shell.view[view];
    const et_doublenet control = et_shell_net(&fit->shell);
    const size_t c = et_doublenet_class(fit->data, view, i, j) - 1;

    bu.set(s->u, s->nu + s->p + 1, s->p, fit->s[view][i]);
    bv.set(s->v, s->nv + s->q + 1, s->q, fit->r[view][j]);
    for (size_t k = 0; k <= s->p; k++)
        for (size_t l = 0; l <= s->q; l++) {
            const double b = bu.value[k] * bv.value[l];

            if (b != 0)
                entries.emplace_back((int)c, (int)et_doublenet_class(control, view, bu.first + k, bv.first + l) - 1, b);
        }
}

void PointsModel::center(const double *y, double mu)
{
    Points step = shift(y);
    VectorXd weight(d.rows());

    if (step.squaredNorm() > 0) {
        metric.to_own(step);
        x += step;
    }
    r = d - a * x;
    for (Index c = 0; c < d.rows(); c++)
        weight[c] = 1 / std::sqrt(r.row(c).squaredNorm() + mu * mu);
    metric.set(a.transpose() * weight.asDiagonal() * a, 0x1p-46);
}

bool PointsModel::evaluate(const double *y, double mu, double *cost, double *gradient)
{
    Points now = shift(y);
    double sum = 0, plain = 0;

    evaluations++;
    metric.to_own(now);
    now += x;
    r.noalias() = d - a * now;
    for (Index c = 0; c < d.rows(); c++) {
        const double square = r.row(c).squaredNorm(), phi = std::sqrt(square + mu * mu);

        sum += phi;
        plain += std::sqrt(square);
        r.row(c) /= -phi;
    }
    if (!std::isfinite(sum))
        return false;
    if (plain < best) {
        best = plain;
        best_points = now;
    }
    *cost = sum;
    if (gradient) {
        now.noalias() = a.transpose() * r;
        metric.to_solver(now);
        Eigen::Map<Points>(gradient, x.rows(), 3) = now;
    }
    return true;
}

/* d/ds of reach * s / sqrt(1 + s^2). */
double slope(double reach, double s)
{
    return reach / ((1 + s * s) * std::sqrt(1 + s * s));
}

/* Everything: control points, their weights, the data's parameters.  Own coordinates are unbounded and of order one:
 * w = w0 exp(b s / sqrt(1 + s^2)) keeps a weight within a factor e^b of its start, u = (1 + t / sqrt(1 + t^2)) / 2 a parameter within (0, 1).
 * What does not move (weights at the corners: the gauge; a border parameter across the border; corner data; a parameter that starts on a bound
 * without belonging there) has no gradient. */
class FullModel : public Model
{
public:
    FullModel(const et_fit *fit, const et_vec3 *data);
    int size() const override
    {
        return (int)(4 * n + 2 * nov);
    }
    double classes() const override
    {
        return (double)nov;
    }
    int inner() const override
    {
        return 40;
    }
    void center(const double *y, double mu) override;
    bool evaluate(const double *y, double mu, double *cost, double *gradient) override;
    double weight(const VectorXd &s, Index k) const
    {
        return w0[k] * et_real_exp(reach * s[k] / std::sqrt(1 + s[k] * s[k]));
    }
    double parameter(const VectorXd &t, Index k) const
    {
        return moves[(size_t)k] ? (1 + t[k] / std::sqrt(1 + t[k] * t[k])) / 2 : fixed[k];
    }

    struct State {
        Points x;                         /* control points */
        VectorXd s, t;                    /* weights, parameters, in own coordinates */
    } now, best_state;

private:
    /* A data class at its parameters: what its surface point reads and how it changes. */
    struct Place {
        std::vector<Index> k;             /* control classes */
        std::vector<double> R;            /* rational basis functions */
        Eigen::RowVector3d S, Su, Sv;
    };

    void start_parameter(Index k, double u, bool free);
    void place(Place &at, const State &z, const VectorXd &w, size_t c);
    State step(const double *y) const;
    void set_metric(double mu);
    void add_gradient(State &g, const Place &at, const State &z, size_t c, const Eigen::RowVector3d &force) const;

    const et_fit *fit;
    et_doublenet control;
    Index n, nov;
    Points d;
    VectorXd w0, fixed;
    std::vector<char> moves, corner;      /* parameters that move; control classes at a corner */
    const double reach = 4.605170185988092;   /* log 100 */
    Basis bu, bv;
    Metric points_metric, weights_metric;
    std::vector<Eigen::LLT<Eigen::Matrix2d>> parameters_metric;
};

FullModel::FullModel(const et_fit *fit_, const et_vec3 *data)
    : fit(fit_), control(et_shell_net(&fit_->shell)), n((Index)et_doublenet_nov(control)), nov((Index)et_doublenet_nov(fit_->data)),
      d(matrix_of(data, (size_t)nov)), w0(VectorXd::Ones(n)), fixed(VectorXd::Zero(2 * nov)), moves((size_t)(2 * nov)), corner((size_t)n),
      parameters_metric((size_t)nov)
{
    std::vector<et_vec3> start((size_t)n);
    size_t corners[4];

    et_shell_gather(start.data(), start.size(), &fit->shell);
    now = {matrix_of(start.data(), start.size()), VectorXd::Zero(n), VectorXd::Zero(2 * nov)};
    et_doublenet_corners(corners, control);
    for (const size_t c : corners)
        corner[c - 1] = 1;
    for (size_t view = ET_BOTTOM; view <= ET_TOP; view++)
        for (size_t k = 0; fit->shell.view[view].weights && k < control.nx * control.ny; k++)
            w0[(Index)et_doublenet_class(control, view, k / control.ny, k % control.ny) - 1] = fit->shell.view[view].weights[k];
    for (Index c = 0; c < nov; c++) {
        const et_index at = et_doublenet_index(fit->data, (size_t)c + 1);
        const size_t view = at.k == 2 ? ET_TOP : ET_BOTTOM;

        start_parameter(2 * c, fit->s[view][at.i], at.i > 0 && at.i + 1 < fit->data.nx);
        start_parameter(2 * c + 1, fit->r[view][at.j], at.j > 0 && at.j + 1 < fit->data.ny);
    }
    best_state = now;
}

void FullModel::start_parameter(Index k, double u, bool free)
{
    moves[(size_t)k] = free && u > 0 && u < 1;
    fixed[k] = u;
    now.t[k] = moves[(size_t)k] ? (2 * u - 1) / (2 * std::sqrt(u * (1 - u))) : 0;
}

void FullModel::place(Place &at, const State &z, const VectorXd &w, size_t c)
{
    const size_t view = c < fit->data.nx * fit->data.ny ? ET_BOTTOM : ET_TOP;
    const et_surface *const f = &fit->shell.view[view];
    const size_t p = f->p, q = f->q;
    double W = 0;

    bu.set(f->u, f->nu + p + 1, p, parameter(z.t, (Index)(2 * c)));
    bv.set(f->v, f->nv + q + 1, q, parameter(z.t, (Index)(2 * c) + 1));
    at.k.resize((p + 1) * (q + 1));
    at.R.resize(at.k.size());
    at.S.setZero();
    at.Su.setZero();
    at.Sv.setZero();
    for (size_t m = 0; m < at.k.size(); m++) {
        at.k[m] = (Index)et_doublenet_class(control, view, bu.first + m / (q + 1), bv.first + m % (q + 1)) - 1;
        at.R[m] = bu.value[m / (q + 1)] * bv.value[m % (q + 1)] * w[at.k[m]];
        W += at.R[m];
        at.S += at.R[m] * z.x.row(at.k[m]);
    }
    at.S /= W;
    for (size_t m = 0; m < at.k.size(); m++) {
        const double wk = w[at.k[m]] / W;
        const size_t i = m / (q + 1), j = m % (q + 1);

        at.R[m] /= W;
        at.Su += bu.value[i + p + 1] * bv.value[j] * wk * (z.x.row(at.k[m]) - at.S);
        at.Sv += bu.value[i] * bv.value[j + q + 1] * wk * (z.x.row(at.k[m]) - at.S);
    }
    /* Slopes in own coordinates. */
    at.Su *= moves[2 * c] ? slope(0.5, z.t[(Index)(2 * c)]) : 0;
    at.Sv *= moves[2 * c + 1] ? slope(0.5, z.t[(Index)(2 * c) + 1]) : 0;
}

FullModel::State FullModel::step(const double *y) const
{
    State z = now;
    Points px = Eigen::Map<const Points>(y, n, 3);
    VectorXd s = Eigen::Map<const VectorXd>(y + 3 * n, n);

    points_metric.to_own(px);
    weights_metric.to_own(s);
    z.x += px;
    z.s += s;
    for (Index c = 0; c < nov; c++)
        z.t.segment<2>(2 * c) += parameters_metric[(size_t)c].matrixU().solve(Eigen::Map<const Eigen::Vector2d>(y + 4 * n + 2 * c));
    return z;
}

void FullModel::center(const double *y, double mu)
{
    if (Eigen::Map<const VectorXd>(y, size()).squaredNorm() > 0)
        now = step(y);
    set_metric(mu);
}

/* The Gauss-Newton matrix of sum |r|^2/phi, its blocks between points, weights and parameters left out. */
void FullModel::set_metric(double mu)
{
    std::vector<Entry> points, weights;
    VectorXd w(n), heavy(3 * nov);
    Place at;

    for (Index k = 0; k < n; k++)
        w[k] = weight(now.s, k);
    for (Index c = 0; c < nov; c++) {
        Eigen::Matrix<double, 3, 2> J;

        place(at, now, w, (size_t)c);
        heavy.segment<3>(3 * c).setConstant(1 / std::sqrt((at.S - d.row(c)).squaredNorm() + mu * mu));
        for (size_t m = 0; m < at.k.size(); m++) {
            const Index k = at.k[m];
            const double scale = corner[(size_t)k] ? 0 : at.R[m] * slope(reach, now.s[k]);

            points.emplace_back((int)c, (int)k, at.R[m]);
            for (Index i = 0; i < 3; i++)
                weights.emplace_back((int)(3 * c + i), (int)k, scale * (now.x(k, i) - at.S[i]));
        }
        J << at.Su.transpose(), at.Sv.transpose();
        Eigen::Matrix2d H = J.transpose() * J * heavy[3 * c];
        H.diagonal().array() += std::max(0.01 * H.trace(), 0x1p-100);
        parameters_metric[(size_t)c].compute(H);
    }
    Matrix A(nov, n), B(3 * nov, n);
    A.setFromTriplets(points.begin(), points.end());
    B.setFromTriplets(weights.begin(), weights.end());
    points_metric.set(A.transpose() * VectorXd(heavy(Eigen::seqN(0, nov, 3))).asDiagonal() * A, 1e-9);
    weights_metric.set(B.transpose() * heavy.asDiagonal() * B, 1e-3);
}

void FullModel::add_gradient(State &g, const Place &at, const State &z, size_t c, const Eigen::RowVector3d &force) const
{
    for (size_t m = 0; m < at.k.size(); m++) {
        const Index k = at.k[m];

        g.x.row(k) += at.R[m] * force;
        if (!corner[(size_t)k])
            g.s[k] += at.R[m] * slope(reach, z.s[k]) * (z.x.row(k) - at.S).dot(force);
    }
    g.t[(Index)(2 * c)] = at.Su.dot(force);
    g.t[(Index)(2 * c) + 1] = at.Sv.dot(force);
}

bool FullModel::evaluate(const double *y, double mu, double *cost, double *gradient)
{
    const State z = step(y);
    State g = {Points::Zero(n, 3), VectorXd::Zero(n), VectorXd::Zero(2 * nov)};
    VectorXd w(n);
    Place at;
    double sum = 0, plain = 0;

    evaluations++;
    for (Index k = 0; k < n; k++)
        w[k] = weight(z.s, k);
    if (!z.x.allFinite() || !z.t.allFinite() || !w.allFinite())
        return false;
    for (Index c = 0; c < nov; c++) {
        place(at, z, w, (size_t)c);
        const Eigen::RowVector3d r = at.S - d.row(c);
        const double phi = std::sqrt(r.squaredNorm() + mu * mu);

        sum += phi;
        plain += r.norm();
        if (gradient)
            add_gradient(g, at, z, (size_t)c, r / phi);
    }
    if (!std::isfinite(sum))
        return false;
    if (plain < best) {
        best = plain;
        best_state = z;
    }
    *cost = sum;
    if (gradient) {
        points_metric.to_solver(g.x);
        weights_metric.to_solver(g.s);
        Eigen::Map<Points>(gradient, n, 3) = g.x;
        Eigen::Map<VectorXd>(gradient + 3 * n, n) = g.s;
        for (Index c = 0; c < nov; c++)
            Eigen::Map<Eigen::Vector2d>(gradient + 4 * n + 2 * c) = parameters_metric[(size_t)c].matrixL().solve(g.t.segment<2>(2 * c));
    }
    return true;
}

/* A model at one mu, as Ceres wants it. */
class Smoothed : public ceres::FirstOrderFunction
{
public:
    Smoothed(Model *model_, double mu_) : model(model_), mu(mu_)
    {
    }
    bool Evaluate(const double *y, double *cost, double *gradient) const override
    {
        return model->evaluate(y, mu, cost, gradient);
    }
    int NumParameters() const override
    {
        return model->size();
    }

private:
    Model *model;
    double mu;
};

/* Counts iterations over all stages, writes the history, asks the caller whether to go on. */
class Watch : public ceres::IterationCallback
{
public:
    Watch(const Model &model_, double *history_, size_t nhistory_, size_t total_, const et_task *task_)
        : model(model_), history(history_), nhistory(history_ ? nhistory_ : 0), total(total_), task(task_)
    {
    }
    ceres::CallbackReturnType operator()(const ceres::IterationSummary &s) override
    {
        if (s.iteration > 0) {
            if (iterations < nhistory)
                history[made++] = model.best;
            iterations++;
        }
        status = et_task_step(task, iterations, total);
        return status == ET_OK ? ceres::SOLVER_CONTINUE : ceres::SOLVER_TERMINATE_SUCCESSFULLY;
    }
    /* A solver that ends by its tolerance does not call back for that iteration. */
    void settle()
    {
        if (made > 0 && made == iterations)
            history[made - 1] = model.best;
    }
    size_t iterations = 0, made = 0;
    et_status status = ET_OK;

private:
    const Model &model;
    double *history;
    size_t nhistory, total;
    const et_task *task;
};

ceres::GradientProblemSolver::Options solver_options(const et_ceres_options &o, int rank, Watch *watch)
{
    ceres::GradientProblemSolver::Options s;

    s.line_search_direction_type = ceres::LBFGS;
    s.max_lbfgs_rank = rank;
    s.function_tolerance = o.tolerance;
    s.gradient_tolerance = 0;
    s.parameter_tolerance = 0;
    s.logging_type = ceres::SILENT;
    s.callbacks.push_back(watch);
    return s;
}

/* One stage: until a change of the metric brings no more than the tolerance, or than `enough`.  True when it ended so. */
bool descend_at(Model &model, double mu, double enough, VectorXd &y, const et_ceres_options &o, Watch &watch)
{
    ceres::GradientProblemSolver::Options options = solver_options(o, model.inner(), &watch);
    const ceres::GradientProblem problem(new Smoothed(&model, mu));

    while (watch.status == ET_OK && watch.iterations < o.iterations) {
        ceres::GradientProblemSolver::Summary summary;

        model.center(y.data(), mu);
        y.setZero();
        options.max_num_iterations = (int)std::min<size_t>((size_t)model.inner(), o.iterations - watch.iterations);
        ceres::Solve(options, problem, y.data(), &summary);
        watch.settle();
        if (!(summary.initial_cost - summary.final_cost > std::max(o.tolerance * summary.initial_cost, enough)))
            return watch.status == ET_OK;
    }
    return false;
}

void descend(Model &model, const et_ceres_options &o, Watch &watch, int *converged)
{
    VectorXd y = VectorXd::Zero(model.size());
    bool done = false;

    for (double mu = o.smooth_start; !done && watch.status == ET_OK && watch.iterations < o.iterations; mu /= 10) {
        done = mu <= o.smooth_end * (1 + 0x1p-20);
        *converged = descend_at(model, done ? o.smooth_end : mu, done ? 0 : 0.01 * mu * model.classes(), y, o, watch) && done;
    }
}

/* A rational copy of a shell with these points and weights. */
et_status rational_shell(et_shell *shell, const et_shell *from, const FullModel &model, const FullModel::State &z)
{
    const et_doublenet control = et_shell_net(from);
    const et_surface *const f = &from->view[ET_BOTTOM];
    const std::vector<et_vec3> points = vectors_of(z.x);
    const et_status status = et_shell_new(shell, f->p, f->q, control, 1);

    if (status != ET_OK)
        return status;
    for (size_t view = ET_BOTTOM; view <= ET_TOP; view++) {
        et_surface *const s = &shell->view[view];

        std::copy_n(from->view[view].u, s->nu + s->p + 1, s->u);
        std::copy_n(from->view[view].v, s->nv + s->q + 1, s->v);
        for (size_t k = 0; k < s->nu * s->nv; k++)
            s->weights[k] = model.weight(z.s, (Index)et_doublenet_class(control, view, k / s->nv, k % s->nv) - 1);
    }
    et_shell_scatter(shell, points.data(), points.size());
    return ET_OK;
}

/* E at each class's own parameters. */
double measure_at(const et_shell *shell, const std::vector<double> &uv, const et_vec3 *data, et_doublenet net)
{
    std::vector<double> work(et_surface_work(&shell->view[ET_BOTTOM])), term(et_doublenet_nov(net));

    for (size_t c = 0; c < term.size(); c++) {
        const et_surface *const s = &shell->view[c < net.nx * net.ny ? ET_BOTTOM : ET_TOP];

        term[c] = et_vec3_distance(data[c], et_surface_point(s, uv[2 * c], uv[2 * c + 1], work.data(), work.size()));
    }
    return et_real_sum(term.data(), term.size());
}

/* Parameters of the data are there and within [0, 1]. */
bool has_parameters(const et_fit *fit)
{
    const auto inside = [](const double *t, size_t n) { return t && std::all_of(t, t + n, [](double x) { return x >= 0 && x <= 1; }); };

    for (size_t view = ET_BOTTOM; view <= ET_TOP; view++)
        if (!inside(fit->s[view], fit->data.nx) || !inside(fit->r[view], fit->data.ny))
            return false;
    return true;
}

et_status check(const et_fit *fit, const et_ceres_summary *summary, const et_vec3 *data, size_t nov, const et_ceres_options &o, et_message *message)
{
    if (!fit || !summary || !data)
        return et_status_fail(message, ET_EINVAL, "ceres: a null pointer");
    if (!(o.iterations > 0 && o.tolerance >= 0 && o.smooth_end > 0 && o.smooth_start >= o.smooth_end && std::isfinite(o.smooth_start)))
        return et_status_fail(message, ET_EINVAL, "ceres: iterations, tolerance or smoothing out of range");
    if (!et_shell_glued(&fit->shell))
        return et_status_fail(message, ET_EINVAL, "ceres: the shell is not glued along its border");
    if (!et_doublenet_valid(fit->data) || nov != et_doublenet_nov(fit->data) || !et_vec3_finite(data, nov))
        return et_status_fail(message, ET_EINVAL, "ceres: data do not belong to the fit, or are not finite");
    if (!has_parameters(fit))
        return et_status_fail(message, ET_EINVAL, "ceres: the fit has no parameters within [0, 1]");
    if (nov > INT_MAX / 8 || et_doublenet_nov(et_shell_net(&fit->shell)) > INT_MAX / 8)   /* Ceres counts unknowns by int */
        return et_status_fail(message, ET_ENOMEM, "ceres: too many unknowns");
    return ET_OK;
}

et_status refine_points(et_fit *fit, et_ceres_summary *summary, double *history, size_t nhistory, const et_vec3 *data, const et_ceres_options &o,
                        const et_task *task)
{
    const size_t nov = et_doublenet_nov(fit->data), n = et_doublenet_nov(et_shell_net(&fit->shell));
    et_ceres_summary sum = {};
    et_fit_error error;
    et_status status = et_fit_measure(&error, nullptr, nov, fit, data);

    if (status != ET_OK)
        return status;
    if (!std::isfinite(error.nov))
        return ET_EINVAL;
    sum.before = sum.after = error.nov;

    PointsModel model(fit, data);
    Watch watch(model, history, nhistory, o.iterations, task);
    std::vector<et_vec3> start(n);

    et_shell_gather(start.data(), n, &fit->shell);
    descend(model, o, watch, &sum.converged);
    et_shell_scatter(&fit->shell, vectors_of(model.best_points).data(), n);
    status = et_fit_measure(&error, nullptr, nov, fit, data);
    if (status != ET_OK || !(error.nov <= sum.before))
        et_shell_scatter(&fit->shell, start.data(), n);
    else
        sum.after = error.nov;
    if (status != ET_OK)
        return status;
    sum.iterations = watch.iterations;
    sum.evaluations = model.evaluations;
    sum.made = watch.made;
    *summary = sum;
    return watch.status;
}

/* Freed whatever is thrown, in the constructor of what it is part of, too. */
struct OwnShell : et_shell {
    OwnShell() : et_shell{} {}
    ~OwnShell()
    {
        et_shell_free(this);
    }
    OwnShell(const OwnShell &) = delete;
    OwnShell &operator=(const OwnShell &) = delete;
};

/* The shell of a state and E there. */
struct Outcome {
    OwnShell shell;
    std::vector<double> uv;
    double E = std::numeric_limits<double>::infinity();
    et_status status;

    Outcome(const et_fit *fit, const et_vec3 *data, const FullModel &model, const FullModel::State &z) : uv((size_t)z.t.size())
    {
        for (size_t k = 0; k < uv.size(); k++)
            uv[k] = model.parameter(z.t, (Index)k);
        status = rational_shell(&shell, &fit->shell, model, z);
        if (status == ET_OK && et_shell_valid(&shell))
            E = measure_at(&shell, uv, data, fit->data);
    }
};

et_status refine_full(et_fit *fit, double *uv, et_ceres_summary *summary, double *history, size_t nhistory, const et_vec3 *data,
                      const et_ceres_options &o, const et_task *task)
{
    et_ceres_summary sum = {};
    FullModel model(fit, data);
    Outcome before(fit, data, model, model.now);
    Watch watch(model, history, nhistory, o.iterations, task);

    if (before.status != ET_OK)
        return before.status;
    if (!std::isfinite(before.E))
        return ET_EINVAL;
    descend(model, o, watch, &sum.converged);
    Outcome after(fit, data, model, model.best_state);
    if (after.status != ET_OK)
        return after.status;
    Outcome &better = after.E <= before.E ? after : before;
    std::copy(better.uv.begin(), better.uv.end(), uv);
    std::swap<et_shell>(fit->shell, better.shell);
    sum.before = before.E;
    sum.after = better.E;
    sum.iterations = watch.iterations;
    sum.evaluations = model.evaluations;
    sum.made = watch.made;
    *summary = sum;
    return watch.status;
}

/* No exception leaves: what is thrown becomes a status. */
template <class Work> et_status guarded(et_message *message, Work work)
{
    et_status status = ET_EINTERNAL;

    try {
        const Silence silence;

        status = work();
    } catch (const std::bad_alloc &) {
        status = ET_ENOMEM;
    } catch (...) {
        status = ET_EINTERNAL;
    }
    return status == ET_OK || status == ET_ESTOPPED ? status : et_status_fail(message, status, "ceres: %s", et_status_text(status));
}

} // namespace

extern "C" et_ceres_options et_ceres_defaults(void)
{
    return {400, 1e-10, 1e-2, 1e-8};
}

extern "C" et_status et_ceres_points(et_fit *fit, et_ceres_summary *summary, double *history, size_t nhistory, const et_vec3 *data, size_t nov,
                                     const et_ceres_options *options, const et_task *task, et_message *message)
{
    const et_ceres_options o = options ? *options : et_ceres_defaults();
    et_status status = check(fit, summary, data, nov, o, message);

    if (status == ET_OK && fit->shell.view[ET_BOTTOM].weights)
        status = et_status_fail(message, ET_EINVAL, "ceres: the shell is rational");
    return status != ET_OK ? status : guarded(message, [&] { return refine_points(fit, summary, history, nhistory, data, o, task); });
}

extern "C" et_status et_ceres_full(et_fit *fit, double *uv, et_ceres_summary *summary, double *history, size_t nhistory, const et_vec3 *data,
                                   size_t nov, const et_ceres_options *options, const et_task *task, et_message *message)
{
    const et_ceres_options o = options ? *options : et_ceres_defaults();
    et_status status = check(fit, summary, data, nov, o, message);

    if (status == ET_OK && !uv)
        status = et_status_fail(message, ET_EINVAL, "ceres: a null pointer");
    return status != ET_OK ? status : guarded(message, [&] { return refine_full(fit, uv, summary, history, nhistory, data, o, task); });
}
